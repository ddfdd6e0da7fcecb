import { signal } from '@preact/signals';
import { buildScene } from '../scene/build_scene.ts';
import { parseObj } from '../scene/parse_obj.ts';
import { parseSceneFile } from '../scene/parse_scene_file.ts';
import type { Scene } from '../scene/scene.ts';
import { describeSceneError, isSceneError, type SceneError } from '../scene/scene_error.ts';
import { type MessageKey, sceneMessages } from './messages/index.ts';

/** Addresses of the scenes' files as built, by file name. */
const urls = Object.fromEntries(
  Object.entries(
    import.meta.glob<string>(['../../../scenes/*.{json,obj,png}', '!**/*.schema.json'], {
      query: '?url',
      import: 'default',
      eager: true,
    }),
  ).map(([path, url]) => [path.slice(path.lastIndexOf('/') + 1), url]),
);

/** In the order of the lesson: one idea more each time. */
export const librarySceneNames = [
  'single-spring-horizontal',
  'horizontal-chain',
  'net',
  'tower',
  'flag',
  'skirt',
] as const;

/** Scenes that the reader opened from files, for this visit. */
export const openedScenes = signal<Scene[]>([]);

/** A scene that cannot be had, as a sentence. */
export class SceneProblem extends Error {
  readonly key: MessageKey;
  readonly params: Record<string, string>;

  constructor(key: MessageKey, params: Record<string, string>) {
    super(key);
    this.key = key;
    this.params = params;
  }
}

/** The scene of that name, opened from files or else of the library. Throws SceneProblem. */
export async function findScene(name: string): Promise<Scene> {
  const opened = openedScenes.value.find((scene) => scene.name === name);
  if (opened) return opened;
  if (!librarySceneNames.some((known) => known === name)) throw new SceneProblem('page.errors.sceneUnknown', { name });
  return readScene(`${name}.json`, fetchText, (file) => urls[file]);
}

/** Opens the scene among files that the reader chose or dropped: one JSON, the OBJ it names, and its picture. Throws SceneProblem. */
export async function openFiles(files: readonly File[]): Promise<Scene> {
  const byName = new Map(files.map((file) => [file.name, file]));
  const json = files.find((file) => /\.json$/i.test(file.name));
  if (!json) throw new SceneProblem('page.errors.sceneNoJson', {});
  const read = (name: string) => {
    const file = byName.get(name);
    if (!file) throw new SceneProblem('page.errors.sceneFileMissing', { file: json.name, missing: name });
    return file.text();
  };
  const scene = await readScene(json.name, read, (name) => {
    const picture = byName.get(name);
    return picture ? URL.createObjectURL(picture) : null;
  });
  openedScenes.value = [...openedScenes.value.filter(({ name }) => name !== scene.name), scene];
  return scene;
}

async function readScene(
  file: string,
  read: (file: string) => Promise<string>,
  pictureUrl: (file: string) => string | null,
): Promise<Scene> {
  const json = trusted(parseSceneFile(file, await read(file)));
  const obj = trusted(parseObj(json.obj, await read(json.obj)));
  return trusted(buildScene(file, json, obj, json.png === undefined ? null : pictureUrl(json.png)));
}

function trusted<T extends object>(result: T | SceneError): T {
  if (isSceneError(result))
    throw new SceneProblem('page.errors.scene', { sentence: describeSceneError(result, sceneMessages()) });
  return result;
}

async function fetchText(file: string): Promise<string> {
  try {
    const response = await fetch(urls[file]);
    if (!response.ok) throw new Error(`HTTP ${response.status}`);
    return await response.text();
  } catch (reason) {
    throw new SceneProblem('page.errors.sceneFetch', { file, reason: (reason as Error).message });
  }
}
