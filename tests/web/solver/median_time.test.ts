import { afterEach, expect, it, vi } from 'vitest';
import { medianTime } from '../../../web/src/solver/median_time.ts';
import { FakeClock } from './fake_clock.ts';

afterEach(() => vi.restoreAllMocks());

it('is that of the work, whatever held up two of five runs', () => {
  const clock = new FakeClock();
  let calls = 0;
  // Each run makes two calls: the first two runs are four times as slow, longer than any tick of the clock.
  expect(medianTime(() => clock.pass(calls++ < 4 ? 16 : 4))).toBe(4);
  expect(calls).toBe(10);
});

it('repeats once what takes long', () => {
  const clock = new FakeClock();
  let calls = 0;
  const call = () => {
    calls++;
    clock.pass(300);
  };
  expect(medianTime(call)).toBe(300);
  expect(calls).toBe(4); // two in each run, and the second run is the last
});
