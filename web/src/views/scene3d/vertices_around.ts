import type { Neighbours } from './neighbours.ts';
import type { Spot } from './surface_hit.ts';

/**
 * The vertices within `radius` of a spot to which a way leads that does not leave the ball: what is near in space, but joined only far away, as one
 * ear to the other, stays out. Those of `fixed` are passed through and left out. Where none is left, the nearest corner of the spot that is not
 * fixed; empty when all are. The nearest first; points #V×3, metres.
 */
export function verticesAround(
  { point, corners }: Spot,
  points: Float64Array,
  neighbours: Neighbours,
  radius: number,
  fixed: ReadonlySet<number>,
): Int32Array {
  const distance2 = (v: number) =>
    (points[3 * v] - point.x) ** 2 + (points[3 * v + 1] - point.y) ** 2 + (points[3 * v + 2] - point.z) ** 2;
  const reached = new Set(corners.filter((v) => distance2(v) <= radius ** 2));
  for (const v of reached) {
    for (const other of neighbours.of(v)) if (distance2(other) <= radius ** 2) reached.add(other);
  }
  const nearestFirst = (vertices: Iterable<number>) =>
    [...vertices].filter((v) => !fixed.has(v)).sort((v, w) => distance2(v) - distance2(w));
  const within = nearestFirst(reached);
  return Int32Array.from(within.length > 0 ? within : nearestFirst(corners).slice(0, 1));
}
