/** Of all springs together, length over rest length: 1 where they are at rest. `p` #V×3, m; `E` #E×2; `r` #E, m. */
export function meanStretch(p: Float64Array, E: Int32Array, r: Float64Array): number {
  let length = 0;
  let rest = 0;
  r.forEach((r_ij, e) => {
    const [i, j] = [3 * E[2 * e], 3 * E[2 * e + 1]];
    length += Math.hypot(p[i] - p[j], p[i + 1] - p[j + 1], p[i + 2] - p[j + 2]);
    rest += r_ij;
  });
  return length / rest;
}
