import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { leastError, shellOf } from '../../../web/src/solver/ik_shell.ts';
import { ikTask } from '../../support/ik_task.ts';
import { solver } from '../../support/open_simulation.ts';

describe('the shell that an end effector can be in', () => {
  it('is a ball for the lab’s chain, and has a hole where one link is longer than the others together', () => {
    expect(shellOf([0.8, 0.4, 0.2, 1.2])).toEqual({ nearest: 0, farthest: expect.closeTo(2.6, 12) });
    // 2 m one way, 0.3 and 0.5 m the other.
    expect(shellOf([0.3, 2, 0.5])).toEqual({ nearest: expect.closeTo(1.2, 12), farthest: expect.closeTo(2.8, 12) });
    expect(shellOf([0.7])).toEqual({ nearest: 0.7, farthest: 0.7 });
  });

  it('is what the solver decides by: UNREACHABLE if and only if the target is further outside than ε, and then at once and as near as can be', () => {
    const unit = fc.double({ min: -1, max: 1, noNaN: true });
    const scene = fc.record({
      links: fc.array(fc.double({ min: 0.2, max: 2, noNaN: true }), { minLength: 2, maxLength: 6 }),
      direction: fc.tuple(unit, unit, unit).filter((d) => Math.hypot(...d) > 0.1),
      distance: fc.double({ min: 0.05, max: 8, noNaN: true }),
      method: fc.constantFrom('ccd', 'fabrik', 'least-squares'),
    });
    const epsilon = 1e-4; // m
    fc.assert(
      fc.property(scene, ({ links, direction, distance, method }) => {
        const shell = shellOf(links);
        const left = leastError(distance, shell);
        fc.pre(Math.abs(left - epsilon) > 1e-9); // at the border itself rounding decides
        const target = direction.map((d, axis) => (axis === 1 ? 1.7 : 0) + (d / Math.hypot(...direction)) * distance);
        const given = { target: Float64Array.from(target), method, epsilon };
        const { answer } = solver.inverse_kinematics(ikTask(given, links));
        expect(answer.outcome === 'UNREACHABLE').toBe(left > epsilon);
        if (left <= epsilon) return;
        expect(answer.iterations).toBe(0);
        expect(answer.error).toBeCloseTo(left, 12);
      }),
      { numRuns: 300 },
    );
  });
});
