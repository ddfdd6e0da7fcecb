import { describe, expect, it } from 'vitest';
import { folderSource } from '../../../web/headless/folder_source.ts';
import { loadScene, type SceneSource } from '../../../web/src/scene/load_scene.ts';
import type { Scene } from '../../../web/src/scene/scene.ts';
import { describeSceneError, isSceneError } from '../../../web/src/scene/scene_error.ts';

const courseFiles = folderSource('tests/support/course_files');

async function load(file: string, source: SceneSource): Promise<Scene> {
  const scene = await loadScene(file, source);
  if (isSceneError(scene)) throw new Error(describeSceneError(scene));
  return scene;
}

describe("the course's format", () => {
  it('a network of springs: two indices a line, masses given', async () => {
    const scene = await load('net.json', courseFiles);
    expect([...scene.E]).toEqual([0, 2, 1, 2, 3, 2, 0, 1]);
    expect([...scene.pinned]).toEqual([0, 1, 3]);
    expect([...scene.m]).toEqual([1, 1, 1, 1]);
    expect(scene.k).toBe(300);
    expect(scene.F).toHaveLength(0);
  });

  it('a cloth: polygons with texture and normal indices, from the front and from the back, masses by area', async () => {
    const scene = await load('cloth.json', courseFiles);
    expect([...scene.E]).toEqual([0, 1, 1, 4, 4, 3, 3, 0, 1, 2, 2, 5, 5, 4]);
    expect([...scene.F]).toEqual([0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4]);
    // Four triangles of ½ m², fanned about vertices 0 and 1: a sixth of a kilogram for each corner.
    expect([...scene.m].map((mass) => Math.round(6 * mass))).toEqual([2, 3, 1, 1, 3, 2]);
    expect([...(scene.texture?.FT ?? [])]).toEqual([...scene.F]);
    expect(scene.texture?.url).toMatch(/course_files\/cloth\.png$/);
  });

  it('a truss: triangles without texture, masses by area', async () => {
    const scene = await load('truss.json', courseFiles);
    expect(scene.E).toHaveLength(2 * 6);
    expect(scene.texture).toBeNull();
    expect(Math.min(...scene.m)).toBeGreaterThan(0);
  });
});

describe('loadScene', () => {
  const files: Record<string, string> = {
    'a.json': '{"obj": "a.obj", "b": [1], "k": 1, "m": 1}',
    'a.obj': 'v 0 0 0\nv 1 0 0\nf 1 2',
    'lost.json': '{"obj": "lost.obj", "b": [1], "k": 1, "m": 1}',
    'dark.json': '{"obj": "a.obj", "png": "dark.png", "b": [1], "k": 1, "m": 1}',
    'broken.json': '{"obj": "broken.obj", "b": [1], "k": 1, "m": 1}',
    'solid.json': '{"mesh": "solid.mesh", "b": [2], "k": 7, "m": 3, "gravity": 0}',
    'solid.mesh':
      'MeshVersionFormatted 2 Dimension 3 Vertices 4 0 9 0 0 1 0 0 0 0 0 1 0 0 0.2 0 0 Tetrahedra 1 1 2 3 4 0',
    'meshless.json': '{"mesh": "lost.mesh", "b": [1], "k": 1, "m": 1}',
    'broken.mesh': 'MeshVersionFormatted 2 Dimension 3 Vertices many',
    'broken.obj': 'v 0 0 0\nv 1 0 0\nf 1 12',
  };
  const source: SceneSource = { read: async (name) => files[name] ?? null, url: () => null };

  it('opens files from wherever they come', async () => {
    expect((await load('a.json', source)).name).toBe('a');
  });

  it('opens a solid by its JSON', async () => {
    const scene = await load('solid.json', source);
    expect(scene).toMatchObject({ name: 'solid', k: 7, gravity: 0, pinned: Int32Array.of(1) });
    expect([scene.E.length, scene.F.length]).toEqual([2 * 6, 3 * 4]);
  });

  it('opens a mesh alone, standing on its lowest vertices, with the numbers of the solids of the library', async () => {
    const scene = await load('solid.mesh', source);
    expect(scene).toMatchObject({
      name: 'solid',
      k: 1e5,
      m: Float64Array.of(1, 1, 1, 1),
      delta_t: 0.005,
      gravity: 9.8,
    });
    expect([...scene.pinned]).toEqual([1, 2, 3]); // up to 3 % of 9 m
  });

  it('goes without a picture that is not there: the springs do not need it', async () => {
    expect((await load('dark.json', source)).texture).toBeNull();
  });

  it.each([
    ['none.json', 'none.json: cannot read none.json'],
    ['lost.json', 'lost.json obj: cannot read lost.obj'],
    ['meshless.json', 'meshless.json mesh: cannot read lost.mesh'],
    ['broken.mesh', 'broken.mesh line 1: many is not a whole number'],
    ['a.obj', 'a.obj line 1: column 1: not JSON from v 0 0 0 on'],
    ['broken.json', 'broken.obj line 3: vertex 12 of 2'],
  ])('says what is wrong with %s', async (file, sentence) => {
    const result = await loadScene(file, source);
    expect(isSceneError(result) && describeSceneError(result)).toBe(sentence);
  });
});
