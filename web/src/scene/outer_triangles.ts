import { tetrahedronVolume } from './tetrahedron_volume.ts';

/** Of a tetrahedron with positive volume: its faces, each counter-clockwise as seen from outside. */
const faces = [
  [1, 2, 3],
  [0, 3, 2],
  [0, 1, 3],
  [0, 2, 1],
];

/**
 * #F by 3, row-major: the faces that belong to one tetrahedron alone, counter-clockwise as seen from outside whatever the order of its corners in the
 * file, then those of `triangles` that are no face of a tetrahedron, as they are. V is #V by 3, T #T by 4.
 */
export function outerTriangles(V: Float64Array, T: Uint32Array, triangles: number[]): number[] {
  const vertexCount = V.length / 3;
  const key = (corners: number[]) => {
    const [a, b, c] = corners.toSorted((i, j) => i - j);
    return (a * vertexCount + b) * vertexCount + c; // of 100,000 vertices: below 2⁵³
  };

  const facesOfAll: number[][] = [];
  const owners = new Map<number, number>();
  for (let t = 0; t < T.length; t += 4) {
    const corners = T.subarray(t, t + 4);
    const [a, b, c, d] = corners;
    const turned = tetrahedronVolume(V, corners) < 0 ? [a, c, b, d] : [a, b, c, d];
    for (const face of faces) {
      const triangle = face.map((corner) => turned[corner]);
      owners.set(key(triangle), (owners.get(key(triangle)) ?? 0) + 1);
      facesOfAll.push(triangle);
    }
  }
  const loose: number[][] = [];
  for (let f = 0; f < triangles.length; f += 3) loose.push(triangles.slice(f, f + 3));
  return [
    ...facesOfAll.filter((triangle) => owners.get(key(triangle)) === 1),
    ...loose.filter((triangle) => !owners.has(key(triangle))),
  ].flat();
}
