import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  angleFromBoth,
  angleFromCosine,
  angleTurned,
  leastKnown,
} from '../../../../../web/src/labs/kinematics/questions/float_angle.ts';
import { angleBetween } from '../../../../../web/src/solver/ik_turns.ts';
import { ikTask } from '../../../../support/ik_task.ts';
import { solver } from '../../../../support/open_simulation.ts';

const half = 2 ** -24; // between floats just below 1

describe('the angle in single precision', () => {
  it('from the cosine takes one of few values where it is small: those of the floats just below 1', () => {
    // cos θ = 1 − 2⁻²⁴ is θ = √(2·2⁻²⁴) = 3.45e-4 rad, but for θ⁴.
    for (const [steps, theta] of [
      [1, 3e-4],
      [1, 4e-4],
      [2, 5e-4],
      [3, 6e-4],
    ] as const)
      expect(angleFromCosine(theta)).toBeCloseTo(Math.sqrt(2 * steps * half), 9);
  });

  it('from the cosine is 0 below the angle whose cosine is rounded to 1', () => {
    // Half-way to the next float: θ²/2 = 2⁻²⁵.
    expect(leastKnown(angleFromCosine)).toBeCloseTo(Math.sqrt(half), 8);
    expect(angleFromCosine(2.4e-4)).toBe(0);
  });

  it('that a library turns by is none up to a cosine of 1 − 2⁻²³', () => {
    // The floats 1, 1 − 2⁻²⁴ and 1 − 2⁻²³ count as 1; from half-way to the next one on it turns: θ²/2 = 2.5·2⁻²⁴.
    expect(leastKnown(angleTurned)).toBeCloseTo(Math.sqrt(5 * half), 8);
  });

  it('from sine and cosine is right to a float’s digits, however small', () => {
    fc.assert(
      fc.property(fc.double({ min: -30, max: 0, noNaN: true }), (exponent) => {
        const theta = 10 ** exponent;
        expect(Math.abs(angleFromBoth(theta) / theta - 1)).toBeLessThan(3 * half); // three roundings
      }),
    );
  });
});

it('the solver turns a joint in single precision as the figure says', () => {
  // One link of 1 m hangs down; the target lies 2 m away, so that its direction alone counts, and joints that may bend by π make the solver search.
  // Between 4e-4 and 8e-4 rad it depends on how the vectors' lengths were rounded, which moves the cosine by a float.
  for (const theta of [1e-4, 3e-4, 4e-4, 8e-4, 1e-3, 1e-2]) {
    const target = Float64Array.of(2 * Math.sin(theta), 1.7 - 2 * Math.cos(theta), 0);
    const given = { target, precision: 'single', iterations: 1, bend_limits: Float64Array.of(Math.PI) } as const;
    const { start_q, q } = solver.inverse_kinematics(ikTask(given, [1])).answer;
    const turned = angleBetween(start_q.subarray(0, 4), q.subarray(0, 4));
    // The target's coordinates are floats, too: 1.7 m is known to 1e-7 m.
    expect(Math.abs(turned - angleTurned(theta))).toBeLessThan(2e-7);
  }
});
