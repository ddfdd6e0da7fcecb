import type { Problem } from './scene_error.ts';

/** An `f` or `l` line of an OBJ file. */
export interface ObjElement {
  line: number;
  keyword: 'f' | 'l';
  /** Each "v", "v/vt", "v//vn" or "v/vt/vn". */
  corners: string[];
  /** How many vertices and texture vertices stand above it: negative indices count back from there. */
  vertices: number;
  textureVertices: number;
}

/** What an element is made of. */
export interface ObjPieces {
  /** Each [i, j], indices of vertices. */
  springs: [number, number][];
  /** #F×3, flat: indices of vertices. */
  triangles: number[];
  /** The same corners, indices of texture vertices; empty when some corner has none. */
  textureTriangles: number[];
}

/** Takes an element apart, once all the vertices of its file have been counted. */
export function takeApart(element: ObjElement, vertexCount: number, textureVertexCount: number): ObjPieces | Problem {
  const { keyword, corners, vertices, textureVertices } = element;
  if (corners.length < 2) return { code: 'too_few_vertices', params: { minimum: 2 } };
  const v: number[] = [];
  const vt: number[] = [];
  for (const corner of corners) {
    const [vertex = '', textureVertex = ''] = corner.split('/');
    const i = readIndex(vertex, vertices);
    if (i === null) return { code: 'not_an_index', params: { value: corner } };
    if (i < 0 || i >= vertexCount)
      return { code: 'vertex_out_of_range', params: { value: vertex, count: vertexCount } };
    v.push(i);
    if (textureVertex === '') continue;
    const t = readIndex(textureVertex, textureVertices);
    if (t === null) return { code: 'not_an_index', params: { value: corner } };
    if (t < 0 || t >= textureVertexCount) {
      return { code: 'texture_vertex_out_of_range', params: { value: textureVertex, count: textureVertexCount } };
    }
    vt.push(t);
  }

  const closed = keyword === 'f' && v.length > 2;
  const springs = v.map((i, c): [number, number] => [i, v[(c + 1) % v.length]]);
  if (!closed) springs.pop();
  const loop = springs.find(([i, j]) => i === j);
  if (loop) return { code: 'self_spring', params: { value: loop[0] + 1 } };
  return {
    springs,
    triangles: closed ? fan(v) : [],
    textureTriangles: closed && vt.length === v.length ? fan(vt) : [],
  };
}

/** Zero-based, perhaps out of range; null when `text` is no index. `above`: how many there are above it. */
function readIndex(text: string, above: number): number | null {
  if (!/^[+-]?0*[1-9]\d*$/.test(text)) return null;
  const index = Number(text);
  return index > 0 ? index - 1 : above + index;
}

/** The triangles of a convex polygon about its first corner. */
function fan(polygon: number[]): number[] {
  return polygon.slice(2).flatMap((c, before) => [polygon[0], polygon[before + 1], c]);
}
