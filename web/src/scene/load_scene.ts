import { buildScene } from './build_scene.ts';
import { parseObj } from './parse_obj.ts';
import { parseSceneFile } from './parse_scene_file.ts';
import type { Scene } from './scene.ts';
import { isSceneError, type Place, type SceneError } from './scene_error.ts';

/** Where a scene's files come from: a folder, a server, or what the user dropped. Names are as the JSON of the scene writes them. */
export interface SceneSource {
  /** The text of a file, null when it cannot be read. */
  read(name: string): Promise<string | null>;
  /** The address at which a picture can be fetched; null when there is no such picture, and the scene goes without. */
  url(name: string): string | null;
}

/** Reads and checks the scene whose JSON is `file`, with the files that it names. */
export async function loadScene(file: string, source: SceneSource): Promise<Scene | SceneError> {
  const unreadable = (value: string, place: Place): SceneError => ({
    code: 'unreadable_file',
    place,
    params: { value },
  });

  const jsonText = await source.read(file);
  if (jsonText === null) return unreadable(file, { file });
  const json = parseSceneFile(file, jsonText);
  if (isSceneError(json)) return json;

  const objText = await source.read(json.obj);
  if (objText === null) return unreadable(json.obj, { file, field: 'obj' });
  const obj = parseObj(json.obj, objText);
  if (isSceneError(obj)) return obj;

  const textureUrl = json.png === undefined ? null : source.url(json.png);
  return buildScene(file, json, obj, textureUrl);
}
