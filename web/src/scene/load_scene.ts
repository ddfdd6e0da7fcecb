import { buildScene } from './build_scene.ts';
import { meshDefaults } from './mesh_defaults.ts';
import { parseMesh } from './parse_mesh.ts';
import { parseObj } from './parse_obj.ts';
import { parseSceneFile } from './parse_scene_file.ts';
import type { Scene } from './scene.ts';
import { isSceneError, type Place, type SceneError } from './scene_error.ts';
import { shapeFile } from './scene_file.ts';

/** Where a scene's files come from: a folder, a server, or what the user dropped. Names are as the JSON of the scene writes them. */
export interface SceneSource {
  /** The text of a file, null when it cannot be read. */
  read(name: string): Promise<string | null>;
  /** The address at which a picture can be fetched; null when there is no such picture, and the scene goes without. */
  url(name: string): string | null;
}

/** Reads and checks the scene whose JSON is `file`, with the files that it names; or a mesh that needs no JSON. */
export async function loadScene(file: string, source: SceneSource): Promise<Scene | SceneError> {
  const text = await source.read(file);
  if (text === null) return unreadable(file, { file });
  if (/\.mesh$/i.test(file)) return meshAlone(file, text);
  const json = parseSceneFile(file, text);
  if (isSceneError(json)) return json;

  const shape = shapeFile(json);
  const shapeText = await source.read(shape);
  if (shapeText === null) return unreadable(shape, { file, field: json.mesh === undefined ? 'obj' : 'mesh' });
  const geometry = json.mesh === undefined ? parseObj(shape, shapeText) : parseMesh(shape, shapeText);
  if (isSceneError(geometry)) return geometry;

  const textureUrl = json.png === undefined ? null : source.url(json.png);
  return buildScene(file, json, geometry, textureUrl);
}

function unreadable(value: string, place: Place): SceneError {
  return { code: 'unreadable_file', place, params: { value } };
}

function meshAlone(file: string, text: string): Scene | SceneError {
  const geometry = parseMesh(file, text);
  if (isSceneError(geometry)) return geometry;
  const json = parseSceneFile(file, JSON.stringify(meshDefaults(file, geometry.V)));
  return isSceneError(json) ? json : buildScene(file, json, geometry, null);
}
