import { expect, it } from 'vitest';
import { steps125 } from '../../../web/src/lib/steps_125.ts';

it('steps are 1, 2, 5 times powers of ten, the ends among them', () => {
  expect(steps125(1, 1000)).toEqual([1, 2, 5, 10, 20, 50, 100, 200, 500, 1000]);
  expect(steps125(0.01, 0.5)).toEqual([0.01, 0.02, 0.05, 0.1, 0.2, 0.5]);
});
