import type { Curve } from '../../curves/curve.ts';
import { type SampledCurve, sampleCurve } from '../../curves/sample_curve.ts';

/** Left, top, width and height of an SVG's view box in m, y downwards. */
export type ViewBox = readonly [number, number, number, number];

/** A curve as SVG has it: y downwards. */
export interface Outline {
  d: string;
  viewBox: ViewBox;
}

/** `margin`: around the curve, of its longer side. `points`: as many lines, so that the eye sees none. */
export function outlineOf(curve: Curve, margin: number, points: number): Outline {
  const sampled = sampleCurve(curve, 'curvature', points);
  return { d: pathThrough(sampled, curve), viewBox: boxAround(sampled.points, margin) };
}

function pathThrough({ points, stroke }: SampledCurve, { strokes }: Curve): string {
  return strokes
    .map(({ closed }, s) => {
      const own = Array.from(stroke, (of, i) => (of === s ? [`${svg(points, i)}`] : [])).flat();
      return `M${own.join('L')}${closed ? 'Z' : ''}`;
    })
    .join('');
}

/** Point i, to a tenth of a millimetre. */
export function svg(points: Float64Array, i: number): string {
  return `${(points[2 * i] as number).toFixed(4)} ${(-(points[2 * i + 1] as number)).toFixed(4)}`;
}

function boxAround(points: Float64Array, margin: number): ViewBox {
  const range = (axis: 0 | 1) => {
    const values = points.filter((_, i) => i % 2 === axis).map((value) => (axis === 0 ? value : -value));
    return [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))] as const;
  };
  const [left, right] = range(0);
  const [top, bottom] = range(1);
  const around = margin * Math.max(right - left, bottom - top);
  return [left - around, top - around, right - left + 2 * around, bottom - top + 2 * around];
}
