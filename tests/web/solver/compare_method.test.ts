import { afterEach, describe, expect, it, vi } from 'vitest';
import { compareMethod } from '../../../web/src/solver/compare_method.ts';
import type { Method, Simulation } from '../../../web/src/solver/module.ts';
import { FakeClock } from './fake_clock.ts';

/** A method whose E halves with every iteration until `last`, each taking `cost` ms; it notes how many it was asked for. */
function fakeSimulation(cost: number, last = Number.POSITIVE_INFINITY) {
  const clock = new FakeClock();
  const asked: number[] = [];
  const compare = (_: Method, iterations: number) => {
    asked.push(iterations);
    const made = Math.min(iterations, last);
    clock.pass(made * cost);
    const rows = Array.from({ length: made + 1 }, (__, k) => [k, 2 ** -k - 1, 2 ** -k, 3 ** -k]);
    return { status: { code: 'ok', field: '', index: -1, value: 0 }, rows: Float64Array.from(rows.flat()) };
  };
  return { asked, simulation: { compare } as unknown as Simulation };
}

const request = { method: 'lbfgs', iterations: 100, patience_ms: 200 } as const;

afterEach(() => vi.restoreAllMocks());

function run(simulation: Simulation) {
  const outcome = compareMethod(simulation, request);
  if (!outcome.ok) throw new Error(outcome.status.code);
  return outcome.value;
}

describe('compareMethod', () => {
  it('makes all iterations of a cheap method, and says what each costs', () => {
    const { simulation } = fakeSimulation(0.25);
    const { change, gradient, decrease, converged, milliseconds } = run(simulation);
    expect([change.length, gradient.length, decrease.length, converged]).toEqual([101, 101, 101, false]);
    expect([change[0], change[2], gradient[2], decrease[2]]).toEqual([0, -0.75, 0.25, 1 / 9]);
    expect(milliseconds).toBe(0.25);
  });

  it('makes no more of a costly method than there is patience for', () => {
    const { asked, simulation } = fakeSimulation(10);
    expect(run(simulation).change).toHaveLength(21); // 20 iterations of 10 ms are 200 ms
    expect(asked).toEqual([1, 4, 16, 20]);
  });

  it('stops where the method does', () => {
    const { asked, simulation } = fakeSimulation(1, 12);
    const { change, converged, milliseconds } = run(simulation);
    expect([change.length, converged, milliseconds]).toEqual([13, true, 1]);
    expect(asked).toEqual([1, 4, 16]);
  });

  it('repeats what is shorter than the clock can tell', () => {
    const { asked, simulation } = fakeSimulation(0.1, 2);
    expect(run(simulation).milliseconds).toBeCloseTo(0.1, 12); // sums of tenths round
    expect(asked.slice(2).length).toBeGreaterThanOrEqual(24); // 24 times 0.2 ms are not yet 5 ms
  });

  it('passes a refusal on', () => {
    const status = { code: 'too_large', field: 'hessian', index: -1, value: 1e9, limit: 1e8 } as const;
    const simulation = { compare: () => ({ status, rows: new Float64Array(0) }) } as unknown as Simulation;
    expect(compareMethod(simulation, request)).toEqual({ ok: false, status });
  });
});
