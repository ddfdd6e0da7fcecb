import { type ObjElement, type ObjProblem, takeApart } from './obj_element.ts';
import type { SceneError } from './scene_error.ts';

/** What a Wavefront OBJ file says, as far as scenes use it. */
export interface ObjData {
  /** #V by 3, metres, row-major. */
  V: Float64Array;
  /** #VT by 2, dimensionless, row-major: texture coordinates. */
  VT: Float32Array;
  /** #E by 2, row-major: springs, indices into the rows of V, in the order and direction in which each first occurs. */
  E: Int32Array;
  /** #F by 3, row-major: triangles, indices into the rows of V; polygons are fanned about their first corner. */
  F: Uint32Array;
  /** #F by 3, row-major: indices into the rows of VT, corner by corner with F; null when some corner has none. */
  FT: Uint32Array | null;
}

/** Caps on what is read, so that a wrong file ends in a sentence and not in a full memory. */
export const maxVertices = 100_000;
export const maxSprings = 500_000;

/**
 * Reads `v`, `vt`, `f` and `l` and ignores the rest. A spring is `f i j`, each edge of a polygon `f i j k …`, and each piece of a polyline `l i j …`;
 * one that occurs again, in either direction, is the same spring. `file` is the name of the file, for the sentences of errors.
 */
export function parseObj(file: string, text: string): ObjData | SceneError {
  const V: number[] = [];
  const VT: number[] = [];
  const elements: ObjElement[] = [];
  for (const [row, statement] of text.split('\n').entries()) {
    const [keyword, ...values] = statement.replace(/#.*/, '').trim().split(/\s+/);
    if (keyword === 'f' || keyword === 'l') {
      elements.push({
        line: row + 1,
        keyword,
        corners: values,
        vertices: V.length / 3,
        textureVertices: VT.length / 2,
      });
    } else if (keyword === 'v' || keyword === 'vt') {
      const problem = keyword === 'v' ? readNumbers(values, 3, V) : readNumbers(values, 2, VT);
      if (problem) return { ...problem, place: { file, line: row + 1 } };
    }
  }
  const vertexCount = V.length / 3;
  if (vertexCount === 0) return { code: 'no_vertices', place: { file }, params: {} };
  if (vertexCount > maxVertices) {
    return { code: 'too_many_vertices', place: { file }, params: { value: vertexCount, maximum: maxVertices } };
  }

  const E: number[] = [];
  const springKeys = new Set<number>();
  const F: number[] = [];
  const FT: number[] = [];
  for (const element of elements) {
    const pieces = takeApart(element, vertexCount, VT.length / 2);
    if ('code' in pieces) return { ...pieces, place: { file, line: element.line } };
    for (const [i, j] of pieces.springs) {
      const key = Math.min(i, j) * vertexCount + Math.max(i, j); // the same in both directions
      if (springKeys.has(key)) continue;
      springKeys.add(key);
      E.push(i, j);
    }
    if (springKeys.size > maxSprings) {
      return { code: 'too_many_springs', place: { file }, params: { maximum: maxSprings } };
    }
    for (const i of pieces.triangles) F.push(i); // one by one: spread arguments of a huge polygon overflow the stack
    for (const i of pieces.textureTriangles) FT.push(i);
  }
  if (E.length === 0) return { code: 'no_springs', place: { file }, params: {} };
  return {
    V: Float64Array.from(V),
    VT: Float32Array.from(VT),
    E: Int32Array.from(E),
    F: Uint32Array.from(F),
    FT: FT.length === F.length ? Uint32Array.from(FT) : null,
  };
}

/** Appends the first `count` of `values` to `list`. */
function readNumbers(values: string[], count: number, list: number[]): ObjProblem | null {
  if (values.length < count) return { code: 'too_few_numbers', params: { value: values.length, minimum: count } };
  for (const value of values.slice(0, count)) {
    const number = Number(value);
    if (!Number.isFinite(number)) return { code: 'not_a_number', params: { value } };
    list.push(number);
  }
  return null;
}
