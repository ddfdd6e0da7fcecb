/** m³: a sixth of ((b − a) × (c − a)) · (d − a); negative where b, c, d run clockwise as seen from a's far side. V is #V by 3. */
export function tetrahedronVolume(V: Float64Array, [a, b, c, d]: Uint32Array): number {
  const side = (to: number) => [0, 1, 2].map((axis) => V[3 * to + axis] - V[3 * a + axis]);
  const [ux, uy, uz] = side(b);
  const [vx, vy, vz] = side(c);
  const [wx, wy, wz] = side(d);
  return ((uy * vz - uz * vy) * wx + (uz * vx - ux * vz) * wy + (ux * vy - uy * vx) * wz) / 6;
}
