import { afterEach, describe, expect, it, vi } from 'vitest';
import { measureIteration } from '../../../web/src/solver/measure_iteration.ts';
import type { Simulation } from '../../../web/src/solver/module.ts';
import { FakeClock } from './fake_clock.ts';

afterEach(() => vi.restoreAllMocks());

describe('measureIteration', () => {
  it('times both halves, however short, and does not count what happens once', () => {
    const clock = new FakeClock();
    let interruption = 8;
    const simulation = {
      rehearse_local_step: (times: number) => clock.pass(times / 1024),
      rehearse_global_step: (times: number) => {
        clock.pass(2 * times + interruption);
        interruption = 0;
      },
    } as unknown as Simulation;
    expect(measureIteration(simulation)).toEqual({ local: 1 / 1024, global: 2 });
  });

  it('keeps a playing page waiting for less than 4 ms of a small scene', () => {
    const clock = new FakeClock();
    let spent = 0;
    const step = (times: number) => {
      clock.pass(times * 0.001);
      spent += times * 0.001;
    };
    measureIteration({ rehearse_local_step: step, rehearse_global_step: step } as unknown as Simulation);
    // Both halves double up to 512 µs, which is once enough, and do that again: 2 × (1 + 2 + … + 512 + 512) µs.
    expect(spent).toBeCloseTo(3.07, 12);
  });
});
