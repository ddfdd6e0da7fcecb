import { describe, expect, it } from 'vitest';
import { defaultKinematics, reachOf } from '../../../../../web/src/app/kinematics.ts';
import type { CurveChoice } from '../../../../../web/src/curves/curve_choice.ts';
import { curveFrom } from '../../../../../web/src/curves/curve_from.ts';
import { first, formulas } from '../../../../../web/src/labs/kinematics/drawing/examples.ts';

const examples: [string, CurveChoice][] = [...Object.entries(formulas), ...Object.entries(first)];

/** m: how far from under its root the lab's arm reaches on the floor. */
const reach = Math.sqrt(reachOf(defaultKinematics) ** 2 - defaultKinematics.root[1] ** 2);

describe('examples', () => {
  it.each(examples)('%s is a curve that the arm reaches all of', (_, choice) => {
    const made = curveFrom(choice);
    if (!made.ok) throw new Error(JSON.stringify(made.problem));
    for (const { from, to, at } of made.curve.strokes)
      for (let k = 0; k <= 1000; k++) {
        const distance = Math.hypot(...at(from + ((to - from) * k) / 1000));
        expect(distance).toBeLessThan(reach);
      }
  });
});
