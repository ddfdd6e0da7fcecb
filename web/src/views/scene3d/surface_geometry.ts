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

/** Whether triangles (#F×3) enclose something: none has an edge without another at it. */
export function encloses(F: Uint32Array): boolean {
  const open = new Set<string>();
  for (let at = 0; at < F.length; at++) {
    const [v, w] = [F[at], F[at % 3 === 2 ? at - 2 : at + 1]];
    if (!open.delete(`${w}/${v}`)) open.add(`${v}/${w}`);
  }
  return F.length > 0 && open.size === 0;
}

/** The triangles around every vertex. */
interface Fans {
  /** #V×2: where in `others` those of a vertex begin and end. */
  fans: Uint32Array;
  /** #F·3×2: the two other vertices of a triangle, in its own order. */
  others: Uint32Array;
}

export function trianglesAround(F: Uint32Array, vertexCount: number): Fans {
  const fans = new Uint32Array(2 * vertexCount);
  for (const vertex of F) fans[2 * vertex + 1] += 1;
  for (let v = 0, end = 0; v < vertexCount; v++) {
    fans[2 * v] = end;
    end += fans[2 * v + 1];
    fans[2 * v + 1] = fans[2 * v];
  }
  const others = new Uint32Array(2 * F.length);
  for (let f = 0; f < F.length; f += 3) {
    for (let corner = 0; corner < 3; corner++) {
      const at = 2 * fans[2 * F[f + corner] + 1]++;
      others[at] = F[f + ((corner + 1) % 3)];
      others[at + 1] = F[f + ((corner + 2) % 3)];
    }
  }
  return { fans, others };
}
