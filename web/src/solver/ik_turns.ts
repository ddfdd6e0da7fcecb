/** rad: the angle of the rotation from a to b, (x, y, z, w), of length 1; from 0 to π. */
export function angleBetween(a: ArrayLike<number>, b: ArrayLike<number>): number {
  // The vector part of a* b is the sine of half of it, which knows small angles; the dot product its cosine.
  const [ax, ay, az, aw] = [a[0], a[1], a[2], a[3]];
  const [bx, by, bz, bw] = [b[0], b[1], b[2], b[3]];
  const x = aw * bx - ax * bw - ay * bz + az * by;
  const y = aw * by - ay * bw - az * bx + ax * bz;
  const z = aw * bz - az * bw - ax * by + ay * bx;
  return 2 * Math.atan2(Math.hypot(x, y, z), Math.abs(ax * bx + ay * by + az * bz + aw * bw));
}

/** rad: the largest angle by which a joint is turned otherwise in one pose than in the other; #joints×4 each. */
export function largestTurn(from: Float64Array, to: Float64Array): number {
  let largest = 0;
  for (let at = 0; at < from.length; at += 4)
    largest = Math.max(largest, angleBetween(from.subarray(at, at + 4), to.subarray(at, at + 4)));
  return largest;
}

/** rad: the largest angle between a link in one pose and the same link in another; #joints×3, m, each. */
export function largestLinkAngle(a: Float64Array, b: Float64Array): number {
  let largest = 0;
  for (let at = 3; at < a.length; at += 3) {
    const [u, v] = [a, b].map((x) => [0, 1, 2].map((axis) => x[at + axis] - x[at + axis - 3]));
    const cross = Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    largest = Math.max(largest, Math.atan2(cross, u[0] * v[0] + u[1] * v[1] + u[2] * v[2]));
  }
  return largest;
}
