/** Writes (1 − fraction) from + fraction to, each #V×3. */
export function interpolatePoints(from: Float64Array, to: Float64Array, fraction: number, out: Float64Array): void {
  for (let c = 0; c < out.length; c++) out[c] = from[c] + fraction * (to[c] - from[c]);
}

/** Distance in metres between row v of p and row v of q, each #V×3. */
export function displacement(p: Float64Array, q: Float64Array, v: number): number {
  const c = 3 * v;
  return Math.hypot(p[c] - q[c], p[c + 1] - q[c + 1], p[c + 2] - q[c + 2]);
}

/** At most `most` of the vertices 0 … count−1, evenly spread, always the same ones so that arrows do not jump between vertices. */
export function thinned(count: number, most: number): Int32Array {
  const kept = Math.min(count, most);
  return Int32Array.from({ length: kept }, (_, a) => Math.floor((a * count) / kept));
}

/** Writes an arrow for each of `vertices` to `out` (#vertices×6), from row v of `tails` to row v of `tips`, each #V×3. */
export function arrowSegments(vertices: Int32Array, tails: Float64Array, tips: Float64Array, out: Float32Array): void {
  vertices.forEach((v, a) => {
    for (let c = 0; c < 3; c++) {
      out[6 * a + c] = tails[3 * v + c];
      out[6 * a + 3 + c] = tips[3 * v + c];
    }
  });
}
