import { type Geometry, maxSprings, maxVertices } from './geometry.ts';
import { type ObjElement, takeApart } from './obj_element.ts';
import type { Problem, SceneError } from './scene_error.ts';
import { SpringList } from './spring_list.ts';

/**
 * Reads `v`, `vt`, `f` and `l` and ignores the rest. A spring is `f i j`, each edge of a polygon `f i j k …`, and each piece of a polyline `l i j …`;
 * one that occurs again, in either direction, is the same spring. Polygons are fanned about their
 * first corner. `file` is the name of the file, for the sentences of errors.
 */
export function parseObj(file: string, text: string): Geometry | SceneError {
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

  const springs = new SpringList(vertexCount);
  const F: number[] = [];
  const FT: number[] = [];
  for (const element of elements) {
    const pieces = takeApart(element, vertexCount, VT.length / 2);
    if ('code' in pieces) return { ...pieces, place: { file, line: element.line } };
    for (const [i, j] of pieces.springs) springs.add(i, j);
    if (springs.count > maxSprings) {
      return { code: 'too_many_springs', place: { file }, params: { maximum: maxSprings } };
    }
    for (const i of pieces.triangles) F.push(i); // one by one: spread arguments of a huge polygon overflow the stack
    for (const i of pieces.textureTriangles) FT.push(i);
  }
  if (springs.count === 0) return { code: 'no_springs', place: { file }, params: {} };
  return {
    V: Float64Array.from(V),
    E: Int32Array.from(springs.E),
    F: Uint32Array.from(F),
    T: new Uint32Array(0),
    VT: Float32Array.from(VT),
    FT: FT.length === F.length ? Uint32Array.from(FT) : null,
  };
}

/** Appends the first `count` of `values` to `list`. */
function readNumbers(values: string[], count: number, list: number[]): Problem | null {
  if (values.length < count) return { code: 'too_few_numbers', params: { value: values.length, minimum: count } };
  for (const value of values.slice(0, count)) {
    const number = Number(value);
    if (!Number.isFinite(number)) return { code: 'not_a_number', params: { value } };
    list.push(number);
  }
  return null;
}
