import { afterEach, expect, it, vi } from 'vitest';
import { timeOf } from '../../../web/src/solver/time_of.ts';
import { FakeClock } from './fake_clock.ts';

afterEach(() => vi.restoreAllMocks());

it('repeats what is shorter than a tick of the clock', () => {
  const clock = new FakeClock();
  expect(timeOf((times) => clock.pass(times / 1024), 20)).toBe(1 / 1024);
});

it('does not take being held up for the work itself', () => {
  const clock = new FakeClock();
  let heldUp = 30;
  const work = (times: number) => {
    clock.pass(times / 1024 + heldUp);
    heldUp = 0;
  };
  expect(timeOf(work, 20)).toBe(1 / 1024);
});
