import { describe, expect, it } from 'vitest';
import { curveFrom } from '../../../../../web/src/curves/curve_from.ts';
import { outlineOf } from '../../../../../web/src/labs/kinematics/outline.ts';
import { spreadOf } from '../../../../../web/src/labs/kinematics/sampling/spread.ts';

function curveOf(kind: 'circle' | 'square') {
  const made = curveFrom({ kind });
  if (!made.ok) throw new Error(made.problem.code);
  return made.curve;
}

describe('spreadOf', () => {
  it('has one gap, the side of the polygon, on a circle', () => {
    const side = 1.2 * Math.sin(Math.PI / 20);
    const spread = spreadOf(curveOf('circle'), 'parameter', 20);
    expect(spread.meanGap).toBeCloseTo(side, 14); // rounding
    expect(spread.largestGap).toBeCloseTo(side, 14);
    expect(spread.error).toBeCloseTo(0.6 * (1 - Math.cos(Math.PI / 20)), 14);
  });

  it('marks the largest gap from its first point to the next, y downwards', () => {
    // Five steps on the four sides of 0.4: two on one of them, so the first whole side is the largest gap.
    expect(spreadOf(curveOf('square'), 'arc-length', 5).gapLine).toBe('M0.2000 0.2000L0.2000 -0.2000');
  });
});

describe('outlineOf', () => {
  it('has the curve in the middle of its view box, with the margin around', () => {
    const { d, viewBox } = outlineOf(curveOf('square'), 0.1, 40);
    viewBox.forEach((value, i) => {
      expect(value).toBeCloseTo([-0.24, -0.24, 0.48, 0.48][i] as number, 12);
    });
    expect(d).toMatch(/^M-0.2000 0.2000L.*Z$/);
  });
});
