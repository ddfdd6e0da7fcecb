import { bezierStroke, type Piece, polyline } from './bezier_stroke.ts';
import { distance, type Point2, type Stroke } from './curve.ts';
import { type CurveResult, refused } from './curve_problem.ts';

/** m. What trembles less than this is the pointer, not the hand. */
const smallestStep = 0.005;
/** m. Several times what any arm of the lab reaches. */
const farthest = 100;

/** What was drawn with the pointer, lightly smoothed: strokes that go through its points without corners. */
export function handCurve(drawn: readonly (readonly Point2[])[]): CurveResult {
  if (drawn.length === 0) return refused('strokes', 1, { code: 'empty' });
  const isNear = ([x, y]: Point2) => Math.abs(x) <= farthest && Math.abs(y) <= farthest; // not so for NaN
  const bad = drawn.findIndex((points) => !points.every(isNear));
  if (bad >= 0) return refused('strokes', bad + 1, { code: 'point_too_far', maximum: farthest });
  const strokes = drawn
    .map(thinned)
    .filter((points) => points.length > 1)
    .map(smoothed);
  return strokes.length > 0 ? { ok: true, curve: { strokes } } : refused('strokes', 1, { code: 'no_length' });
}

/** `points` without those that hardly differ from the one before. */
function thinned(points: readonly Point2[]): Point2[] {
  const kept: Point2[] = [];
  for (const point of points) {
    const last = kept.at(-1);
    if (!last || distance(last, point) >= smallestStep) kept.push(point);
  }
  return kept;
}

/** By a Catmull–Rom spline: at each point the direction is that from the point before to the one behind. */
function smoothed(points: readonly Point2[]): Stroke {
  if (points.length === 2) return polyline(points, false);
  const point = (i: number) => points[Math.min(Math.max(i, 0), points.length - 1)] as Point2;
  const beside = ([x, y]: Point2, [ax, ay]: Point2, [bx, by]: Point2): Point2 => [x + (bx - ax) / 6, y + (by - ay) / 6];
  const pieces = points.slice(1).map((end, i): Piece => {
    const start = point(i);
    return [start, beside(start, point(i - 1), end), beside(end, point(i + 2), start), end];
  });
  return { ...bezierStroke(pieces, false), corners: [] };
}
