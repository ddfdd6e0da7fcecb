import { describe, expect, it } from 'vitest';
import { placeOf } from '../../../web/src/solver/read_frame.ts';

describe('placeOf', () => {
  it('walks a time step of two iterations: predict, local, global, local, global, accept', () => {
    expect([0, 1, 2, 3, 4, 5].map((half_step) => placeOf(half_step, 5))).toEqual([
      { phase: 'predict', iteration: 0 },
      { phase: 'local', iteration: 1 },
      { phase: 'global', iteration: 1 },
      { phase: 'local', iteration: 2 },
      { phase: 'global', iteration: 2 },
      { phase: 'accept', iteration: 2 },
    ]);
  });
});
