import type { Geometry } from './geometry.ts';
import { tetrahedronVolume } from './tetrahedron_volume.ts';

/** kg/m², of a surface that gives the vertices their masses. */
const areaDensity = 1;
/** kg/m³, of a solid that does. */
const volumeDensity = 1;

/** #V, kg: a third of the mass of each triangle around a vertex. */
export function massesByArea({ V, F }: Geometry): Float64Array {
  const m = new Float64Array(V.length / 3);
  for (let f = 0; f < F.length; f += 3) {
    const corners = F.subarray(f, f + 3);
    const third = (areaDensity * triangleArea(V, corners)) / 3;
    for (const i of corners) m[i] += third;
  }
  return m;
}

/** #V, kg: a quarter of the mass of each tetrahedron around a vertex. */
export function massesByVolume({ V, T }: Geometry): Float64Array {
  const m = new Float64Array(V.length / 3);
  for (let t = 0; t < T.length; t += 4) {
    const corners = T.subarray(t, t + 4);
    const quarter = (volumeDensity * Math.abs(tetrahedronVolume(V, corners))) / 4;
    for (const i of corners) m[i] += quarter;
  }
  return m;
}

/** m²: half the length of (b − a) × (c − a). */
function triangleArea(V: Float64Array, [a, b, c]: Uint32Array): number {
  const side = (from: number, to: number) => [0, 1, 2].map((axis) => V[3 * to + axis] - V[3 * from + axis]);
  const [ux, uy, uz] = side(a, b);
  const [vx, vy, vz] = side(a, c);
  return Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
}
