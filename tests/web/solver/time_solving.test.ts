import { afterEach, describe, expect, it, vi } from 'vitest';
import type { SolverModule } from '../../../web/src/solver/module.ts';
import {
  type SolvingTime,
  solvingCalls,
  timeRefactorising,
  timeSolving,
} from '../../../web/src/solver/time_solving.ts';
import { solver } from '../../support/open_simulation.ts';
import { FakeClock } from './fake_clock.ts';

afterEach(() => vi.restoreAllMocks());

/** A module on which each call takes so many ms on a net of n vertices. */
function fakeModule(milliseconds: (call: string, n: number) => number) {
  const clock = new FakeClock();
  const deleted: number[] = [];
  class Example {
    constructor(side: number) {
      const n = side * side;
      Object.assign(this, { vertex_count: () => n, delete: () => deleted.push(n) });
      for (const call of solvingCalls) Object.assign(this, { [call]: () => clock.pass(milliseconds(call, n)) });
    }
  }
  return { module: { SolvingExample: Example } as unknown as SolverModule, deleted };
}

function timesOf(module: SolverModule, sides: readonly number[]): SolvingTime[] {
  const times: SolvingTime[] = [];
  timeSolving(module, sides, (time) => times.push(time));
  return times;
}

describe('timeSolving', () => {
  it('times every call on every net and frees the nets', () => {
    const { module, deleted } = fakeModule((call, n) => (call.startsWith('dense') ? n / 64 : n / 1024));
    const times = timesOf(module, [2, 4]);
    expect(times).toHaveLength(2 * solvingCalls.length);
    expect(times).toContainEqual({ call: 'dense_inverse', n: 4, milliseconds: 4 / 64 });
    expect(times).toContainEqual({ call: 'sparse_substitute', n: 16, milliseconds: 16 / 1024 });
    expect(deleted).toEqual([4, 16]);
  });

  it('gives up a way whose calls took too long, and dense matrices where they grow too large', () => {
    const { module } = fakeModule((call, n) => (call === 'dense_inverse' ? n : 1));
    const largest = (call: string) =>
      Math.max(...timesOf(module, [10, 20, 40, 60]).map((t) => (t.call === call ? t.n : 0)));
    expect(largest('dense_inverse')).toBe(400);
    expect(largest('dense_substitute')).toBe(1600);
    expect(largest('sparse_substitute')).toBe(3600);
  });

  it('runs on the real module', () => {
    expect(timesOf(solver, [5]).every(({ n, milliseconds }) => n === 25 && milliseconds > 0)).toBe(true);
  });
});

describe('timeRefactorising', () => {
  it('counts a factorisation with every solve, or none', () => {
    const { module } = fakeModule((call) => (call.endsWith('factorise') ? 8 : 1));
    const expected = { once: 50, everyTime: 450 };
    expect(timeRefactorising(module, 5, 50)).toEqual({ dense: expected, sparse: expected });
  });
});
