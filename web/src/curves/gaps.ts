import type { Curve, Point2, Stroke } from './curve.ts';
import type { SampledCurve } from './sample_curve.ts';

/** From one point of a stroke to its next; the last of a closed stroke has one too, back to the first. */
export interface Gap {
  /** Index of the point before it. */
  at: number;
  start: Point2;
  end: Point2;
  stroke: Stroke;
  /** Parameters of the stroke at its ends. */
  from: number;
  to: number;
}

export function gapsOf({ points, stroke, t }: SampledCurve, { strokes }: Curve): Gap[] {
  const point = (i: number): Point2 => [points[2 * i] as number, points[2 * i + 1] as number];
  const gaps: Gap[] = [];
  let first = 0; // of the stroke
  for (let i = 0; i < t.length; i++) {
    if (stroke[i] !== stroke[first]) first = i;
    const of = strokes[stroke[i] as number] as Stroke;
    const gap = { at: i, start: point(i), stroke: of, from: t[i] as number };
    if (stroke[i + 1] === stroke[i]) gaps.push({ ...gap, end: point(i + 1), to: t[i + 1] as number });
    else if (of.closed) gaps.push({ ...gap, end: point(first), to: of.to });
  }
  return gaps;
}
