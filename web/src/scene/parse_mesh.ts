import { type Geometry, maxSprings, maxVertices } from './geometry.ts';
import { isName, MeshWords } from './mesh_words.ts';
import { outerTriangles } from './outer_triangles.ts';
import type { Problem, SceneError } from './scene_error.ts';
import { SpringList } from './spring_list.ts';

/** The sections that scenes use, and the numbers of a row before its reference, a label that nothing here needs. */
const columns = { Vertices: 3, Tetrahedra: 4, Triangles: 3, Edges: 2 };
type SectionName = keyof typeof columns;
/** Those whose rows are vertices, counted from 1. */
const elementNames = ['Tetrahedra', 'Triangles', 'Edges'] as const;

interface Section {
  /** Row by row. */
  values: number[];
  /** Where each row stands. */
  lines: number[];
}

/**
 * Reads a Medit mesh, written as text. Each edge of a tetrahedron, triangle or edge is a spring, once. The surface is what bounds the tetrahedra, and the
 * triangles that are no face of one. `file` is the name of the file, for the sentences of errors.
 */
export function parseMesh(file: string, text: string): Geometry | SceneError {
  const sections = readSections(file, text);
  if ('code' in sections) return sections;

  const vertexCount = sections.Vertices.lines.length;
  if (vertexCount === 0) return { code: 'no_vertices', place: { file }, params: {} };
  if (vertexCount > maxVertices) {
    return { code: 'too_many_vertices', place: { file }, params: { value: vertexCount, maximum: maxVertices } };
  }

  const springs = new SpringList(vertexCount);
  for (const name of elementNames) {
    const { values, lines } = sections[name];
    for (const [row, line] of lines.entries()) {
      const corners = values.slice(columns[name] * row, columns[name] * (row + 1));
      const problem = cornersProblem(corners, vertexCount);
      if (problem) return { ...problem, place: { file, line } };
      for (const [c, i] of corners.entries()) for (const j of corners.slice(c + 1)) springs.add(i, j);
      if (springs.count > maxSprings) {
        return { code: 'too_many_springs', place: { file }, params: { maximum: maxSprings } };
      }
    }
  }
  if (springs.count === 0) return { code: 'no_springs', place: { file }, params: {} };

  const V = Float64Array.from(sections.Vertices.values);
  const T = Uint32Array.from(sections.Tetrahedra.values);
  return {
    V,
    E: Int32Array.from(springs.E),
    F: Uint32Array.from(outerTriangles(V, T, sections.Triangles.values)),
    T,
    VT: new Float32Array(0),
    FT: null,
  };
}

/** Elements' rows with their indices from 0, perhaps out of range: the vertices may stand below them. */
function readSections(file: string, text: string): Record<SectionName, Section> | SceneError {
  const words = new MeshWords(text);
  const sections: Record<SectionName, Section> = {
    Vertices: { values: [], lines: [] },
    Tetrahedra: { values: [], lines: [] },
    Triangles: { values: [], lines: [] },
    Edges: { values: [], lines: [] },
  };
  if (words.peek() !== 'MeshVersionFormatted') return { code: 'not_a_mesh', place: { file }, params: {} };
  for (let name = words.next(); name !== null && name !== 'End'; name = words.next()) {
    const problem = readSection(name, words, sections);
    if (problem) return { ...problem, place: { file, line: words.line } };
  }
  return sections;
}

function readSection(name: string, words: MeshWords, sections: Record<SectionName, Section>): Problem | null {
  if (isSectionName(name)) return readRows(name, words, sections[name]);
  if (!isName(name)) return { code: 'not_a_section', params: { value: name } };
  if (name === 'Dimension') {
    const dimension = words.next() ?? '';
    return dimension === '3' ? null : { code: 'not_in_space', params: { value: dimension } };
  }
  for (let word = words.peek(); word !== null && !isName(word); word = words.peek()) words.next();
  return null;
}

function isSectionName(name: string): name is SectionName {
  return Object.hasOwn(columns, name);
}

function readRows(name: SectionName, words: MeshWords, { values, lines }: Section): Problem | null {
  const count = words.next() ?? '';
  if (!/^\d+$/.test(count)) return { code: 'not_a_whole_number', params: { value: count } };
  for (let row = 0; row < Number(count); row++) {
    const first = words.peek();
    if (first === null || isName(first)) {
      return { code: 'too_few_rows', params: { section: name, value: row, count: Number(count) } };
    }
    for (let column = 0; column < columns[name]; column++) {
      const problem = readValue(name, words.next() ?? '', values);
      if (problem) return problem;
    }
    lines.push(words.line);
    words.next(); // the reference
  }
  return null;
}

function readValue(name: SectionName, word: string, values: number[]): Problem | null {
  const number = Number(word);
  if (name === 'Vertices') {
    if (word === '' || !Number.isFinite(number)) return { code: 'not_a_number', params: { value: word } };
    values.push(number);
  } else {
    if (!/^0*[1-9]\d*$/.test(word)) return { code: 'not_an_index', params: { value: word } };
    values.push(number - 1);
  }
  return null;
}

function cornersProblem(corners: number[], vertexCount: number): Problem | null {
  const missing = corners.find((i) => i >= vertexCount);
  if (missing !== undefined) return { code: 'vertex_out_of_range', params: { value: missing + 1, count: vertexCount } };
  const double = corners.find((i, c) => corners.indexOf(i) < c);
  return double === undefined ? null : { code: 'self_spring', params: { value: double + 1 } };
}
