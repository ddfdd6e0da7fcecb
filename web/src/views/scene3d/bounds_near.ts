import type { Rectangle } from '../../lib/rectangle.ts';

/** CSS pixels left free around what is pointed at, for its thickness and the pointer. */
const margin = 10;
/** Farther than this from the pointer it matters no more. */
const reach = 60;

/** The rectangle around points (#×2) and a pointer at (x, y), no farther from the pointer than matters. All in CSS pixels. */
export function boundsNear(points: Float32Array, x: number, y: number): Rectangle {
  const [left, right] = rangeNear(points, 0, x);
  const [top, bottom] = rangeNear(points, 1, y);
  return { x: left, y: top, width: right - left, height: bottom - top };
}

function rangeNear(points: Float32Array, axis: 0 | 1, pointer: number): [number, number] {
  let [least, most] = [pointer, pointer];
  for (let at = axis; at < points.length; at += 2) {
    least = Math.min(least, points[at]);
    most = Math.max(most, points[at]);
  }
  return [Math.max(least, pointer - reach) - margin, Math.min(most, pointer + reach) + margin];
}
