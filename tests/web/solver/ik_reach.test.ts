import { describe, expect, it } from 'vitest';
import { reachByAll } from '../../../web/src/solver/ik_reach.ts';
import { leastError, shellOf } from '../../../web/src/solver/ik_shell.ts';
import { largestLinkAngle } from '../../../web/src/solver/ik_turns.ts';
import { type IkMethod, ikMethods } from '../../../web/src/solver/inverse_kinematics.ts';
import { ikTask } from '../../support/ik_task.ts';
import { solver } from '../../support/open_simulation.ts';

const labLinks = [0.8, 0.4, 0.2, 1.2];

/** The target lies so far to the right of the root, the one beside it 1 cm higher. */
function reach(distance: number, links = labLinks) {
  const target = Float64Array.of(distance, 1.7, 0);
  const reached = reachByAll(solver, ikTask({ target }, links), Float64Array.of(distance, 1.71, 0));
  if (!reached.ok) throw new Error(reached.status.code);
  return reached.value;
}

describe.each(ikMethods)('%s', (method: IkMethod) => {
  it('knows at once, having asked for the distance, that it cannot get there', () => {
    for (const distance of [2.61, 2.7, 4]) {
      const { outcome, iterations, error } = reach(distance)[method].tested;
      expect([outcome, iterations]).toEqual(['UNREACHABLE', 0]);
      expect(error).toBeCloseTo(distance - 2.6, 12);
    }
  });

  it('turns the arm by just the angle by which the target moves', () => {
    const { tested, beside } = reach(2.7)[method];
    expect(largestLinkAngle(tested.x, beside.x)).toBeCloseTo(Math.atan(0.01 / 2.7), 12);
  });

  it('searches in vain without having asked, dozens of iterations and more, and the next frame goes on', () => {
    const { untested, again } = reach(2.7)[method];
    expect(untested.iterations).toBeGreaterThan(50);
    expect(again.iterations).toBeGreaterThan(20);
    expect(untested.outcome).toBe('UNREACHABLE');
  });

  it('never comes nearer than the distance allows', () => {
    for (const [distance, links] of [
      [2.7, labLinks],
      [0.3, [0.8, 0.4, 0.2, 2.2]],
    ] as const) {
      const least = leastError(distance, shellOf(links));
      for (const error of reach(distance, [...links])[method].untested.errors)
        expect(error).toBeGreaterThan(least - 1e-12); // rounding
    }
  });

  it('asks or does not ask: within reach both are the same search', () => {
    const { tested, untested } = reach(1.5)[method];
    expect(tested.outcome).toBe('CONVERGED');
    expect(untested.iterations).toBe(tested.iterations);
  });
});

it('a target on the root is refused', () => {
  const root = Float64Array.of(0, 1.7, 0);
  expect(reachByAll(solver, ikTask({ target: root }), root)).toMatchObject({
    ok: false,
    status: { code: 'on_root', field: 'target' },
  });
});
