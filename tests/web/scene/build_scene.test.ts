import { describe, expect, it } from 'vitest';
import { buildScene } from '../../../web/src/scene/build_scene.ts';
import type { Geometry } from '../../../web/src/scene/geometry.ts';
import { parseMesh } from '../../../web/src/scene/parse_mesh.ts';
import { parseObj } from '../../../web/src/scene/parse_obj.ts';
import type { Scene } from '../../../web/src/scene/scene.ts';
import { describeSceneError, isSceneError, type SceneError } from '../../../web/src/scene/scene_error.ts';
import type { SceneFile } from '../../../web/src/scene/scene_file.ts';

// Two right triangles with legs 3 m and 4 m: 6 m² each.
const rectangle = 'v 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nf 1 2 3\nf 1 3 4\n';

type Fields = Omit<SceneFile, 'obj' | 'mesh'>;
const file = { obj: 'a.obj', b: [], k: 10, delta_t: 0.1, iterations: 5, w: 1e6, gravity: 1.6, damping: 0.3 };

function build(objText: string, fields: Partial<Fields> = {}, textureUrl: string | null = null): Scene | SceneError {
  const obj = parseObj('a.obj', objText);
  if (isSceneError(obj)) throw new Error(describeSceneError(obj));
  return buildScene('scenes/a.json', { ...file, ...fields }, obj, textureUrl);
}

function solid(sections: string): Geometry {
  const mesh = parseMesh('a.mesh', `MeshVersionFormatted 2 Dimension 3 ${sections}`);
  if (isSceneError(mesh)) throw new Error(describeSceneError(mesh));
  return mesh;
}

function built(...parameters: Parameters<typeof build>): Scene {
  const scene = build(...parameters);
  if (isSceneError(scene)) throw new Error(describeSceneError(scene));
  return scene;
}

describe('buildScene', () => {
  it('names the scene after its file and hands its numbers on', () => {
    expect(built(rectangle)).toMatchObject({ name: 'a', k: 10, delta_t: 0.1, iterations: 5, w: 1e6, texture: null });
    expect(built(rectangle)).toMatchObject({ gravity: 1.6, damping: 0.3 });
  });

  it('counts pinned vertices from zero, ascending', () => {
    expect([...built(rectangle, { b: [4, 1, 2] }).pinned]).toEqual([0, 1, 3]);
  });

  it('gives every vertex the mass of the file', () => {
    expect([...built(rectangle, { m: 0.5 }).m]).toEqual([0.5, 0.5, 0.5, 0.5]);
  });

  it('gives every vertex a third of each of its triangles, at 1 kg/m², when the file says no mass', () => {
    expect([...built(rectangle).m]).toEqual([4, 2, 4, 2]);
  });

  it('gives every vertex a quarter of each of its tetrahedra, at 1 kg/m³, when a solid has no mass', () => {
    // 2 · 3 · 4 m over 6: 4 m³, and the same on the other side of face 1 2 3, whose corners are in both.
    const vertices = 'Vertices 5 0 0 0 0 2 0 0 0 0 3 0 0 0 0 4 0 0 0 -4 0';
    const scene = buildScene('a.json', file, solid(`${vertices} Tetrahedra 2 1 2 3 4 0 1 2 3 5 0`), null);
    expect(scene).toMatchObject({ m: Float64Array.of(2, 2, 2, 1, 1) });
  });

  it('refuses a solid without mass with a vertex in no tetrahedron', () => {
    const mesh = solid('Vertices 5 0 0 0 0 2 0 0 0 0 3 0 0 0 0 4 0 9 9 9 0 Tetrahedra 1 1 2 3 4 0 Triangles 1 1 2 5 0');
    const result = buildScene('a.json', file, mesh, null);
    expect(isSceneError(result) && describeSceneError(result)).toBe(
      'a.json m: this field is missing, and vertex 5 is in no tetrahedron whose volume could give it one',
    );
  });

  it('lays the picture on by the texture coordinates', () => {
    const { texture } = built('v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nf 1/1 2/2 3/1', {}, 'a.png');
    expect(texture).toEqual({ url: 'a.png', VT: Float32Array.of(0, 0, 1, 0), FT: Uint32Array.of(0, 1, 0) });
  });

  it.each<[string, Partial<Fields>, string | null, string]>([
    [rectangle, { b: [1, 5] }, null, 'scenes/a.json b[1]: vertex 5 of 4'],
    [rectangle, { b: [1, 2, 1] }, null, 'scenes/a.json b[2]: vertex 1 is pinned twice'],
    [
      'v 0 0 0\nv 1 0 0\nf 1 2',
      {},
      null,
      'scenes/a.json m: this field is missing, and vertex 1 is in no triangle whose area could give it one',
    ],
    [
      `${rectangle}v 9 9 9`,
      {},
      null,
      'scenes/a.json m: this field is missing, and vertex 5 is in no triangle whose area could give it one',
    ],
    [
      'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3',
      {},
      null,
      'scenes/a.json m: this field is missing, and vertex 1 is in no triangle whose area could give it one',
    ],
    [rectangle, {}, 'a.png', 'scenes/a.json png: a.obj lacks texture coordinates on some corner'],
  ])('refuses case %#', (objText, fields, textureUrl, sentence) => {
    const result = build(objText, fields, textureUrl);
    expect(isSceneError(result) && describeSceneError(result)).toBe(sentence);
  });
});
