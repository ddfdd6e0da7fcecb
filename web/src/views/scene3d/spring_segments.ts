/** Numbers in a row of segments: start (metres), packed colour, end (metres), nothing. Rows are made for two texels of four. */
export const segmentStride = 8;

/** Writes the springs themselves, from p_i to p_j, to rows of `out` (#E×8). `p` #V×3, `E` #E×2. */
export function springSegments(p: Float64Array, E: Int32Array, out: Float32Array): void {
  for (let e = 0; e < E.length / 2; e++) {
    const i = 3 * E[2 * e];
    const j = 3 * E[2 * e + 1];
    for (let c = 0; c < 3; c++) {
      out[segmentStride * e + c] = p[i + c];
      out[segmentStride * e + 4 + c] = p[j + c];
    }
  }
}

/** How short and how long a piece may be drawn, in lengths of its spring; a true projection (exaggeration 1) is never cut. */
const shortest = 0.2;
const longest = 2;

/** Length in metres of the piece drawn for a spring of length l and rest length r. */
export function pieceLength(l: number, r: number, exaggeration: number): number {
  return Math.max(Math.min(shortest * l, r), Math.min(Math.max(longest * l, r), l + exaggeration * (r - l)));
}

/**
 * Writes each spring torn out of the net to rows of `out` (#E×8): about its own midpoint, along its projection d (#E×3, d_e points from j to i),
 * turned and resized by the fraction `tear` of the way from the whole spring. At tear 0 it is the spring itself.
 */
export function pieceSegments(
  p: Float64Array,
  E: Int32Array,
  r: Float64Array,
  d: Float64Array,
  exaggeration: number,
  tear: number,
  out: Float32Array,
): void {
  for (let e = 0; e < r.length; e++) {
    const i = 3 * E[2 * e];
    const j = 3 * E[2 * e + 1];
    const x = p[i] - p[j];
    const y = p[i + 1] - p[j + 1];
    const z = p[i + 2] - p[j + 2];
    const l = Math.sqrt(x * x + y * y + z * z);
    const along = r[e] > 0 ? (tear * pieceLength(l, r[e], exaggeration)) / (2 * r[e]) : 0;
    const kept = (1 - tear) / 2;
    const hx = kept * x + along * d[3 * e];
    const hy = kept * y + along * d[3 * e + 1];
    const hz = kept * z + along * d[3 * e + 2];
    const mx = (p[i] + p[j]) / 2;
    const my = (p[i + 1] + p[j + 1]) / 2;
    const mz = (p[i + 2] + p[j + 2]) / 2;
    out[segmentStride * e] = mx + hx;
    out[segmentStride * e + 1] = my + hy;
    out[segmentStride * e + 2] = mz + hz;
    out[segmentStride * e + 4] = mx - hx;
    out[segmentStride * e + 5] = my - hy;
    out[segmentStride * e + 6] = mz - hz;
  }
}

/** Metres: l of spring e. */
export function springLength(p: Float64Array, E: Int32Array, e: number): number {
  const i = 3 * E[2 * e];
  const j = 3 * E[2 * e + 1];
  return Math.sqrt((p[i] - p[j]) ** 2 + (p[i + 1] - p[j + 1]) ** 2 + (p[i + 2] - p[j + 2]) ** 2);
}

/** (l − r)/r of spring e, dimensionless: infinite when only its rest length is zero. */
export function springStrain(p: Float64Array, E: Int32Array, r: Float64Array, e: number): number {
  const l = springLength(p, E, e);
  return l === r[e] ? 0 : l / r[e] - 1;
}
