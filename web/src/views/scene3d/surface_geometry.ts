import type { Scene3DModel } from './types.ts';

interface SurfaceCorners {
  /** #corners: the vertex of the net that each corner follows. */
  vertices: Int32Array;
  /** #corners×2; zero without a texture. */
  uvs: Float32Array;
  /** #F×3: indices of corners. */
  triangles: Uint32Array;
}

/** One corner for each pair of vertex and texture coordinate that occurs: where a texture has a seam, one vertex has several. */
export function surfaceCorners(F: Uint32Array, texture: Scene3DModel['texture']): SurfaceCorners {
  const cornerOf = new Map<string, number>();
  const vertices: number[] = [];
  const uvs: number[] = [];
  const triangles = F.map((vertex, at) => {
    const row = texture ? texture.FT[at] : 0;
    const key = `${vertex}/${row}`;
    const known = cornerOf.get(key);
    if (known !== undefined) return known;
    cornerOf.set(key, vertices.length);
    uvs.push(texture ? texture.VT[2 * row] : 0, texture ? texture.VT[2 * row + 1] : 0);
    return vertices.push(vertex) - 1;
  });
  return { vertices: Int32Array.from(vertices), uvs: Float32Array.from(uvs), triangles };
}

/** Writes unit normals (#V×3): the sum of the adjacent triangles' normals, each weighted by its area; zero where there is none. */
export function vertexNormals(p: Float64Array, F: Uint32Array, out: Float32Array): void {
  out.fill(0);
  for (let f = 0; f < F.length; f += 3) {
    const a = 3 * F[f];
    const b = 3 * F[f + 1];
    const c = 3 * F[f + 2];
    const ux = p[b] - p[a];
    const uy = p[b + 1] - p[a + 1];
    const uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a];
    const vy = p[c + 1] - p[a + 1];
    const vz = p[c + 2] - p[a + 2];
    for (let at = f; at < f + 3; at++) {
      const corner = 3 * F[at];
      out[corner] += uy * vz - uz * vy;
      out[corner + 1] += uz * vx - ux * vz;
      out[corner + 2] += ux * vy - uy * vx;
    }
  }
  for (let v = 0; v < out.length; v += 3) {
    const length = Math.sqrt(out[v] ** 2 + out[v + 1] ** 2 + out[v + 2] ** 2);
    if (length > 0) for (let c = 0; c < 3; c++) out[v + c] /= length;
  }
}

/** Writes the chosen rows of `from` (#×3), one after the other, to `out` (#rows×3). */
export function takeRows(from: ArrayLike<number>, rows: Int32Array, out: { [at: number]: number }): void {
  for (let to = 0; to < rows.length; to++) {
    const at = 3 * rows[to];
    out[3 * to] = from[at];
    out[3 * to + 1] = from[at + 1];
    out[3 * to + 2] = from[at + 2];
  }
}
