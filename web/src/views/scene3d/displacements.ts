/** Writes (1 − fraction) from + fraction to, each #V×3. */
export function interpolatePoints(from: Float64Array, to: Float64Array, fraction: number, out: Float64Array): void {
  for (let c = 0; c < out.length; c++) out[c] = from[c] + fraction * (to[c] - from[c]);
}

/** Distance in metres between row v of p and row v of q, each #V×3. */
export function displacement(p: Float64Array, q: Float64Array, v: number): number {
  const c = 3 * v;
  return Math.hypot(p[c] - q[c], p[c + 1] - q[c + 1], p[c + 2] - q[c + 2]);
}

/**
 * Indices of at most `most` of the points V (#V×3, metres), evenly spread: the first in each cell of the finest grid that has so few.
 * They depend on rest positions alone, so arrows do not jump between vertices.
 */
export function thinned(V: Float64Array, most: number): Int32Array {
  if (V.length / 3 <= most) return Int32Array.from({ length: V.length / 3 }, (_, v) => v);
  const extent = V.reduce((largest, coordinate) => Math.max(largest, Math.abs(coordinate)), 0);
  for (let cell = extent / finestCells; ; cell *= 1.2) {
    const chosen = firstInCells(V, cell, most);
    if (chosen) return Int32Array.from(chosen);
  }
}

/** Of the finest grid, from the origin to the farthest coordinate. */
const finestCells = 256;

/** Null, as soon as that is known, when more than `most` cells have a point. */
function firstInCells(V: Float64Array, cell: number, most: number): number[] | null {
  const cells = new Set<number>();
  const first: number[] = [];
  const along = (c: number) => Math.floor(V[c] / cell);
  const apart = 4 * finestCells; // more than there are along an axis
  for (let v = 0; v < V.length / 3; v++) {
    cells.add((along(3 * v) * apart + along(3 * v + 1)) * apart + along(3 * v + 2));
    if (cells.size === first.length) continue;
    if (cells.size > most) return null;
    first.push(v);
  }
  return first;
}
