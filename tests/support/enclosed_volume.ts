/** m³: of what a closed surface encloses, by the divergence theorem; positive when its triangles run counter-clockwise as seen from outside. V is #V by 3, F #F by 3. */
export function enclosedVolume(V: Float64Array, F: ArrayLike<number>): number {
  let sixfold = 0;
  for (let f = 0; f < F.length; f += 3) {
    const [a, b, c] = [F[f], F[f + 1], F[f + 2]].map((i) => V.subarray(3 * i, 3 * i + 3));
    sixfold +=
      a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sixfold / 6;
}
