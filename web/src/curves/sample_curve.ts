import type { Curve, Stroke } from './curve.ts';
import { evenStretches, parameterAt, stepsOf } from './even_stretch.ts';
import type { Sampling } from './sampling.ts';

/** Points of a curve in the order of drawing. A closed stroke's end is not repeated: the gap back to its start closes it. */
export interface SampledCurve {
  /** #P by 2, m. */
  points: Float64Array;
  /** #P. Which stroke each is on. */
  stroke: Int32Array;
  /** #P. Where on the stroke. */
  t: Float64Array;
}

/** The ends of every stroke, and its corners. */
export function fewestPoints({ strokes }: Curve): number {
  return strokes
    .map(({ corners, closed }) => (closed ? Math.max(corners.length + 1, 2) : corners.length + 2))
    .reduce((a, b) => a + b, 0);
}

/**
 * `budget` points of the curve, or fewestPoints(curve) if that is more.
 * - parameter: equal steps of t, in all strokes as nearly the same as whole numbers of steps permit.
 * - arc-length: equal lengths likewise, with a point in every corner.
 * - curvature: likewise, one half by length and the other by turning: density 1 + κ L/Θ, Θ being how far the curve of length L turns in all.
 */
export function sampleCurve(curve: Curve, sampling: Sampling, budget: number): SampledCurve {
  const stretches = evenStretches(curve, sampling);
  const steps = stepsOf(stretches, curve, Math.max(Math.floor(budget), fewestPoints(curve)));
  const points: number[] = [];
  const stroke: number[] = [];
  const parameter: number[] = [];
  const add = (s: number, t: number) => {
    points.push(...(curve.strokes[s] as Stroke).at(t));
    stroke.push(s);
    parameter.push(t);
  };
  for (const [i, stretch] of stretches.entries()) {
    const count = steps[i] as number;
    for (let k = 0; k < count; k++) add(stretch.stroke, parameterAt(stretch, k / count));
    const { closed, to } = curve.strokes[stretch.stroke] as Stroke;
    const isLastOfStroke = stretches[i + 1]?.stroke !== stretch.stroke;
    if (isLastOfStroke && !closed) add(stretch.stroke, to);
  }
  return { points: Float64Array.from(points), stroke: Int32Array.from(stroke), t: Float64Array.from(parameter) };
}
