import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Curve, distance } from '../../../web/src/curves/curve.ts';
import { gapsOf } from '../../../web/src/curves/gaps.ts';
import { largestError } from '../../../web/src/curves/largest_error.ts';
import { largestGap } from '../../../web/src/curves/largest_gap.ts';
import { fewestPoints, type SampledCurve, sampleCurve } from '../../../web/src/curves/sample_curve.ts';
import { samplings } from '../../../web/src/curves/sampling.ts';
import { curveOf, someChoices } from './some_curves.ts';

const circle = curveOf({ kind: 'circle' });
const heart = curveOf({ kind: 'heart' });
const ellipse = curveOf({ kind: 'formula', x: 'cos(t)', y: 'sin(t)/4', from: '0', to: '2 pi' });

/** Arc length between the parameters of every gap, by chords so many that their error is below 1e-7 of it. */
function lengthsOfGaps(sampled: SampledCurve, curve: Curve): number[] {
  const chords = 2000;
  return gapsOf(sampled, curve).map(({ stroke, from, to }) => {
    let length = 0;
    let [x, y] = stroke.at(from);
    for (let k = 1; k <= chords; k++) {
      const [nextX, nextY] = stroke.at(from + ((to - from) * k) / chords);
      length += Math.hypot(nextX - x, nextY - y);
      [x, y] = [nextX, nextY];
    }
    return length;
  });
}

describe('sampleCurve', () => {
  it('keeps the budget, gives every stroke its ends and, but by parameter, its corners', () => {
    fc.assert(
      fc.property(
        fc.constantFrom(...someChoices.map(curveOf)),
        fc.constantFrom(...samplings),
        fc.integer({ min: 1, max: 400 }),
        (curve, sampling, budget) => {
          const sampled = sampleCurve(curve, sampling, budget);
          expect(sampled.t.length).toBe(Math.max(budget, fewestPoints(curve)));
          expect(sampled.points.every(Number.isFinite)).toBe(true);
          for (const [s, { from, to, corners, closed }] of curve.strokes.entries()) {
            const t = [...sampled.t].filter((_, i) => sampled.stroke[i] === s);
            expect(t.length).toBeGreaterThanOrEqual(2);
            expect(t[0]).toBe(from);
            if (!closed) expect(t.at(-1)).toBe(to);
            if (sampling !== 'parameter') expect(t).toEqual(expect.arrayContaining([...corners]));
            expect(t.every((one, i) => i === 0 || one > (t[i - 1] as number))).toBe(true);
            if (closed) expect(t.at(-1)).toBeLessThan(to);
          }
        },
      ),
    );
  });

  it('takes equal steps of the parameter', () => {
    const { t } = sampleCurve(heart, 'parameter', 10);
    for (let k = 0; k < 10; k++) expect(t[k]).toBeCloseTo(Math.PI / 2 + (k * Math.PI) / 5, 14); // rounding
  });

  it.each([
    ['circle', circle, 1.2 * Math.PI],
    ['heart', heart, 4], // 8a of the cardioid a(1 − sin t)
    ['ellipse', ellipse, 4.28921088], // 4 E(√(15/16)), from tables of the elliptic integral
  ])('divides the length of the %s evenly', (_, curve, length) => {
    for (const lengthOfGap of lengthsOfGaps(sampleCurve(curve, 'arc-length', 50), curve))
      expect(Math.abs(lengthOfGap - length / 50)).toBeLessThan(3e-6 * length); // 1e-6 at either end, 1e-6 of the length itself
  });

  it('divides the sides of a polygon as evenly as whole numbers permit', () => {
    // Legs 0.5, hypotenuse 0.7071: 10 steps are 3, 4 and 3, of 0.1667, 0.1768 and 0.1667.
    const triangle = curveOf({ kind: 'triangle' });
    const gaps = lengthsOfGaps(sampleCurve(triangle, 'arc-length', 10), triangle);
    const expected = [0.5 / 3, 0.5 / 3, 0.5 / 3, ...Array(4).fill(Math.SQRT1_2 / 4), 0.5 / 3, 0.5 / 3, 0.5 / 3];
    expect(gaps).toEqual(expected.map((gap) => expect.closeTo(gap, 6))); // 1e-6 of the length, as above
  });

  it('by curvature is by length where the curvature is constant', () => {
    const byLength = sampleCurve(circle, 'arc-length', 40);
    sampleCurve(circle, 'curvature', 40).t.forEach((t, k) => {
      expect(Math.abs(t - (byLength.t[k] as number))).toBeLessThan(1e-5); // 1e-6 of 2π in either
    });
  });

  it('by curvature has the density 1 + κ L/Θ', () => {
    // An ellipse turns by Θ = 2π. With the half-axes 1 and ¼ κ is 16 at (1, 0), where the points begin, and ¼ at (0, ¼).
    const gaps = lengthsOfGaps(sampleCurve(ellipse, 'curvature', 400), ellipse);
    const kappaScale = 4.28921088 / (2 * Math.PI);
    const ratio = (gaps[100] as number) / (gaps[0] as number);
    const expected = (1 + 16 * kappaScale) / (1 + 0.25 * kappaScale);
    expect(ratio / expected).toBeGreaterThan(0.97); // the density changes by a few percent within the first gap
    expect(ratio / expected).toBeLessThan(1.03);
  });
});

describe('largestGap', () => {
  it('by curvature is hardly more than twice the average, for only half of the points go by turning', () => {
    for (const choice of someChoices) {
      const curve = curveOf(choice);
      const sampled = sampleCurve(curve, 'curvature', 400);
      const chords = gapsOf(sampled, curve).map(({ start, end }) => distance(start, end));
      const mean = chords.reduce((sum, chord) => sum + chord, 0) / chords.length;
      expect(largestGap(sampled, curve).length).toBeLessThan(2.1 * mean); // whole numbers of steps
    }
  });

  it('of n points on a circle is a side of the regular polygon', () => {
    for (const n of [8, 31, 400]) {
      const { length } = largestGap(sampleCurve(circle, 'parameter', n), circle);
      expect(length).toBeCloseTo(1.2 * Math.sin(Math.PI / n), 14); // rounding
    }
  });

  it('is never smaller by parameter than by length, but for what whole numbers and chords permit', () => {
    for (const choice of someChoices) {
      const curve = curveOf(choice);
      const [byParameter, byLength] = (['parameter', 'arc-length'] as const).map(
        (sampling) => largestGap(sampleCurve(curve, sampling, 300), curve).length,
      ) as [number, number];
      expect(byLength).toBeLessThan(1.05 * byParameter);
    }
  });

  it('of the heart is at its tip when t steps evenly', () => {
    // There the pen is fastest: |dp/dt| = √(2 · 0.5² (1 − sin t)) has its maximum 1 at t = 3π/2.
    const { at, length } = largestGap(sampleCurve(heart, 'parameter', 40), heart);
    expect([19, 20]).toContain(at);
    expect(length).toBeCloseTo((2 * Math.PI) / 40, 2);
  });
});

describe('largestError', () => {
  it('on a circle is r (1 − cos(π/n))', () => {
    for (const n of [8, 31, 400])
      expect(largestError(sampleCurve(circle, 'parameter', n), circle)).toBeCloseTo(
        0.6 * (1 - Math.cos(Math.PI / n)),
        14,
      ); // rounding
  });

  it('is none on polygons whose corners have points, and some where they have not', () => {
    const star = curveOf({ kind: 'star' });
    expect(largestError(sampleCurve(star, 'arc-length', 33), star)).toBeLessThan(1e-15);
    expect(largestError(sampleCurve(star, 'parameter', 33), star)).toBeGreaterThan(0.001);
  });

  it('is smaller by curvature than by length where the curvature differs much', () => {
    const [byLength, byCurvature] = (['arc-length', 'curvature'] as const).map((sampling) =>
      largestError(sampleCurve(ellipse, sampling, 40), ellipse),
    ) as [number, number];
    expect(byCurvature).toBeLessThan(byLength / 2);
  });
});
