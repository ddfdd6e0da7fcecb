import { lowestVertices } from './lowest_vertices.ts';

/** N/m, kg, s: of Levin's course, whose solids these meshes are like. With any other, its step would not be the one that students know. */
const k = 1e5;
const m = 1;
const delta_t = 0.005;
/** With 50 a solid would be slow to watch; in steps so short, ten take the rabbit of 2.5 m within 2 mm of the same place in a second. */
const iterations = 10;

/** What the JSON of a mesh says that gets one by rule: the library's solids, and a mesh that is opened alone. */
export function meshDefaults(file: string, V: Float64Array) {
  return { mesh: file, k, m, iterations, delta_t, b: lowestVertices(V).map((i) => i + 1) };
}
