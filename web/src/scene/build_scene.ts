import type { ObjData } from './parse_obj.ts';
import type { Scene } from './scene.ts';
import type { SceneError } from './scene_error.ts';
import type { SceneFile } from './scene_file.ts';

/** kg/m², of the surface that gives the vertices their masses. */
const areaDensity = 1;

/** Puts a scene together from its two files. `file` is the name of the JSON; `textureUrl` is where its picture is, null when it names none. */
export function buildScene(file: string, json: SceneFile, obj: ObjData, textureUrl: string | null): Scene | SceneError {
  const vertexCount = obj.V.length / 3;
  const fail = (code: SceneError['code'], field: string, params: SceneError['params']): SceneError => ({
    code,
    place: { file, field },
    params,
  });

  const pinned = new Set<number>();
  for (const [row, vertex] of json.b.entries()) {
    if (vertex > vertexCount) return fail('vertex_out_of_range', `b[${row}]`, { value: vertex, count: vertexCount });
    if (pinned.has(vertex - 1)) return fail('duplicate_pin', `b[${row}]`, { value: vertex });
    pinned.add(vertex - 1);
  }

  const m = json.m === undefined ? massesByArea(obj) : new Float64Array(vertexCount).fill(json.m);
  const massless = m.findIndex((mass) => !(mass > 0));
  if (massless >= 0) return fail('no_mass', 'm', { value: massless + 1 });

  if (textureUrl !== null && obj.FT === null) return fail('no_texture_coordinates', 'png', { value: json.obj });
  return {
    name: file.replace(/^.*\//, '').replace(/\.json$/i, ''),
    V: obj.V,
    E: obj.E,
    F: obj.F,
    texture: textureUrl !== null && obj.FT !== null ? { url: textureUrl, VT: obj.VT, FT: obj.FT } : null,
    m,
    pinned: Int32Array.from(pinned).sort(),
    k: json.k,
    delta_t: json.delta_t,
    iterations: json.iterations,
    w: json.w,
  };
}

/** #V, kg: a third of the mass of each triangle around a vertex. */
function massesByArea({ V, F }: ObjData): Float64Array {
  const m = new Float64Array(V.length / 3);
  for (let f = 0; f < F.length; f += 3) {
    const corners = F.subarray(f, f + 3);
    const third = (areaDensity * triangleArea(V, corners)) / 3;
    for (const i of corners) m[i] += third;
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
