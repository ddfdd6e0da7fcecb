/** How short and how long a piece may be drawn, in lengths of its spring; a true projection (exaggeration 1) is never cut. */
const shortest = 0.2;
const longest = 2;

/** Length in metres of the piece drawn for a spring of length l and rest length r. */
export function pieceLength(l: number, r: number, exaggeration: number): number {
  return Math.max(Math.min(shortest * l, r), Math.min(Math.max(longest * l, r), l + exaggeration * (r - l)));
}

/** What became of a net's springs: each whole, or turned and resized by the fraction `tear` of the way to its enlarged projection. */
export interface Tear {
  /** #E×3: row e points from j to i, |d_e| = r_e. */
  d: Float64Array;
  exaggeration: number;
  tear: number;
}

/**
 * Writes what is drawn of each spring to rows of `out` (#E×4): half of it, from its middle towards i (metres), and its strain as a share of
 * `strainRange`, −1 … 1. `p` #V×3, `E` #E×2, `r` #E, metres.
 */
export function writePieces(
  p: Float64Array,
  E: Int32Array,
  r: Float64Array,
  torn: Tear | null,
  strainRange: number,
  out: Float32Array,
): void {
  const { d, exaggeration, tear } = torn ?? { d: null, exaggeration: 1, tear: 0 };
  const kept = (1 - tear) / 2;
  for (let e = 0; e < r.length; e++) {
    const i = 3 * E[2 * e];
    const j = 3 * E[2 * e + 1];
    const x = p[i] - p[j];
    const y = p[i + 1] - p[j + 1];
    const z = p[i + 2] - p[j + 2];
    const l = Math.sqrt(x * x + y * y + z * z);
    out[4 * e] = kept * x;
    out[4 * e + 1] = kept * y;
    out[4 * e + 2] = kept * z;
    if (d && r[e] > 0) {
      const along = (tear * pieceLength(l, r[e], exaggeration)) / (2 * r[e]);
      out[4 * e] += along * d[3 * e];
      out[4 * e + 1] += along * d[3 * e + 1];
      out[4 * e + 2] += along * d[3 * e + 2];
    }
    out[4 * e + 3] = Math.max(-1, Math.min(1, strain(l, r[e]) / strainRange));
  }
}

/** Where the pieces lie, as pointers look for them: #E×6, metres. */
export function pieceEnds(p: Float64Array, E: Int32Array, pieces: Float32Array): Float32Array {
  const ends = new Float32Array(3 * E.length);
  for (let e = 0; e < E.length / 2; e++) {
    for (let c = 0; c < 3; c++) {
      const middle = (p[3 * E[2 * e] + c] + p[3 * E[2 * e + 1] + c]) / 2;
      ends[6 * e + c] = middle + pieces[4 * e + c];
      ends[6 * e + 3 + c] = middle - pieces[4 * e + c];
    }
  }
  return ends;
}

/** Where whole springs lie: #E×6, metres. */
export function springEnds(p: Float64Array, E: Int32Array): Float32Array {
  const ends = new Float32Array(3 * E.length);
  for (let end = 0; end < E.length; end++) {
    for (let c = 0; c < 3; c++) ends[3 * end + c] = p[3 * E[end] + c];
  }
  return ends;
}

/** Metres: l of spring e. */
export function springLength(p: Float64Array, E: Int32Array, e: number): number {
  const i = 3 * E[2 * e];
  const j = 3 * E[2 * e + 1];
  return Math.sqrt((p[i] - p[j]) ** 2 + (p[i + 1] - p[j + 1]) ** 2 + (p[i + 2] - p[j + 2]) ** 2);
}

/** (l − r)/r, dimensionless: infinite when only the rest length is zero. */
export function strain(l: number, r: number): number {
  return l === r ? 0 : l / r - 1;
}
