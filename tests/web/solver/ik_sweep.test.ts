import { describe, expect, it } from 'vitest';
import { type SweepStart, sweep } from '../../../web/src/solver/ik_sweep.ts';
import { type IkTask, ikMethods } from '../../../web/src/solver/inverse_kinematics.ts';
import { circle, heart, ikTask } from '../../support/ik_task.ts';
import { solver } from '../../support/open_simulation.ts';

const degree = Math.PI / 180;

function along(curve: Float64Array, start: SweepStart, given: Partial<IkTask> = {}) {
  const swept = sweep(solver, ikTask(given), curve, start);
  if (!swept.ok) throw new Error(swept.status.code);
  return swept.value;
}

/** Every fourth of the targets: the arm has to go further from one to the next. */
const coarse = (curve: Float64Array) => curve.filter((_, at) => Math.floor(at / 3) % 4 === 0);

describe.each(ikMethods)('along a curve by %s', (method) => {
  it('an arm that starts where it was turns its joints by a few degrees; from random poses it flips', () => {
    for (const curve of [circle, heart]) {
      const [warm, random] = [along(curve, 'warm', { method }), along(curve, 'random', { method })];
      expect(Math.max(...warm.turns) / degree).toBeLessThan(10);
      expect(Math.max(...random.turns) / degree).toBeGreaterThan(90);
      expect(warm.outcomes.every((outcome) => outcome === 'CONVERGED')).toBe(true);
    }
  });

  it('no joint turns further than its limit, and the arm is never nearer for it', () => {
    for (const limit of [0.3, 1, 3]) {
      const free = along(coarse(heart), 'warm', { method });
      const limited = along(coarse(heart), 'warm', { method, turn_limit: limit * degree });
      expect(Math.max(...limited.turns) / degree).toBeLessThan(limit + 1e-6); // the solver's quaternions: rounding
      // Errors below ε are as chance has it.
      expect(Math.max(...limited.errors)).toBeGreaterThan(Math.max(...free.errors) - 1e-4);
    }
  });

  it('a limit that is never met changes nothing', () => {
    const free = along(circle, 'warm', { method });
    const limited = along(circle, 'warm', { method, turn_limit: 20 * degree });
    limited.turns.forEach((turn, at) => {
      expect(turn).toBeCloseTo(free.turns[at], 9); // FABRIK's positions pass through rotations either way
    });
  });
});

it('a tight limit makes the arm lag: it is no longer where the targets are', () => {
  const { errors } = along(coarse(heart), 'warm', { turn_limit: 0.5 * degree });
  expect(Math.max(...errors)).toBeGreaterThan(0.01);
});

it('random poses are the same every time, so that the experiment can be repeated', () => {
  expect(along(circle, 'random')).toEqual(along(circle, 'random'));
});

it('what is refused is refused as for a single target', () => {
  expect(sweep(solver, ikTask({ iterations: 0 }), circle, 'warm')).toMatchObject({
    ok: false,
    status: { code: 'not_positive', field: 'iterations' },
  });
});
