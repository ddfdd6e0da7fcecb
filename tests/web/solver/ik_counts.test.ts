import { describe, expect, it } from 'vitest';
import { countIterations } from '../../../web/src/solver/ik_counts.ts';
import { circle, heart, ikTask } from '../../support/ik_task.ts';
import { solver } from '../../support/open_simulation.ts';

/** A clock that a test knows: 1 ms between two looks at it. */
function ticking(): () => number {
  let time = 0;
  return () => time++;
}

function count(epsilon: number) {
  const counted = countIterations(solver, ikTask({ epsilon }), [circle, heart], ticking());
  if (!counted.ok) throw new Error(counted.status.code);
  return counted.value;
}

const median = (values: Int32Array) => values.slice().sort()[values.length >> 1];

describe('the iterations that all targets take', () => {
  const usual = count(1e-4);
  const of = (counts: typeof usual, method: string, precision: string) =>
    counts.filter((one) => one.method === method && one.precision === precision)[0];

  it('are told of every target, for three methods in two precisions, with the time of one', () => {
    expect(usual).toHaveLength(6);
    for (const { iterations, outcomes, time } of usual) {
      expect(iterations).toHaveLength(400);
      expect(outcomes).toHaveLength(400);
      expect(time).toBe(1 / 400);
    }
  });

  it('are in double precision few, and every target is reached', () => {
    const most = { ccd: 25, fabrik: 8, 'least-squares': 8 };
    for (const { method, precision, iterations, outcomes, largestError } of usual) {
      if (precision === 'single') continue;
      expect(median(iterations)).toBeLessThanOrEqual(most[method]);
      expect(outcomes.every((outcome) => outcome === 'CONVERGED')).toBe(true);
      expect(largestError).toBeLessThanOrEqual(1e-4);
    }
  });

  it('end for CCD in single precision at nearly every target in a stall, millimetres away; FABRIK does not need the angle', () => {
    const stalls = of(usual, 'ccd', 'single').outcomes.filter((outcome) => outcome === 'STALLED');
    expect(stalls.length).toBeGreaterThan(360); // nine of ten
    expect(of(usual, 'ccd', 'single').largestError).toBeGreaterThan(1e-3);
    expect(of(usual, 'fabrik', 'single').outcomes).toEqual(of(usual, 'fabrik', 'double').outcomes);
  });

  it('suffice for CCD in single precision once ε over the length of the arm is an angle that it knows', () => {
    // 2e-3 m / 2.6 m = 7.7e-4 rad, above the 5.5e-4 rad below which it makes no rotation.
    expect(of(count(2e-3), 'ccd', 'single').outcomes.every((outcome) => outcome === 'CONVERGED')).toBe(true);
  });

  it('are refused like a single target', () => {
    expect(countIterations(solver, ikTask({ epsilon: 0 }), [circle], ticking())).toMatchObject({
      ok: false,
      status: { code: 'not_positive', field: 'epsilon' },
    });
  });
});
