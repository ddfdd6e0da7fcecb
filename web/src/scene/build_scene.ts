import type { Geometry } from './geometry.ts';
import { massesByArea, massesByVolume } from './masses.ts';
import type { Scene } from './scene.ts';
import type { SceneError } from './scene_error.ts';
import { type SceneFile, shapeFile } from './scene_file.ts';

/** Puts a scene together from its two files. `file` is the name of the JSON, or of the mesh that has none; `textureUrl` is where its picture is, null when it names none. */
export function buildScene(
  file: string,
  json: SceneFile,
  geometry: Geometry,
  textureUrl: string | null,
): Scene | SceneError {
  const { V, E, F, T, VT, FT } = geometry;
  const vertexCount = V.length / 3;
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

  const solid = T.length > 0;
  const byShape = () => (solid ? massesByVolume(geometry) : massesByArea(geometry));
  const m = json.m === undefined ? byShape() : new Float64Array(vertexCount).fill(json.m);
  const massless = m.findIndex((mass) => !(mass > 0));
  if (massless >= 0) return fail(solid ? 'no_mass_of_solid' : 'no_mass', 'm', { value: massless + 1 });

  if (textureUrl !== null && FT === null) return fail('no_texture_coordinates', 'png', { value: shapeFile(json) });
  return {
    name: file.replace(/^.*\//, '').replace(/\.(json|mesh)$/i, ''),
    V,
    E,
    F,
    texture: textureUrl !== null && FT !== null ? { url: textureUrl, VT, FT } : null,
    m,
    pinned: Int32Array.from(pinned).sort(),
    k: json.k,
    delta_t: json.delta_t,
    iterations: json.iterations,
    w: json.w,
    gravity: json.gravity,
    damping: json.damping,
  };
}
