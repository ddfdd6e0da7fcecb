import { signal } from '@preact/signals';
import { loadScene } from '../scene/load_scene.ts';
import type { Scene } from '../scene/scene.ts';
import { describeSceneError, isSceneError, type SceneError } from '../scene/scene_error.ts';
import { type MessageKey, sceneMessages } from './messages/index.ts';
import { notify } from './notices.ts';

/** Addresses of the scenes' files as built, by file name. */
const urls = Object.fromEntries(
  Object.entries(
    import.meta.glob<string>(['../../../scenes/*.{json,obj,png}', '!../../../scenes/*.schema.json'], {
      query: '?url',
      import: 'default',
      eager: true,
    }),
  ).map(([path, url]) => [path.slice(path.lastIndexOf('/') + 1), url]),
);

/** In the order of the lesson: one idea more each time. */
export const librarySceneNames = [
  'single-spring-horizontal',
  'triangle',
  'horizontal-chain',
  'patch',
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
  return trusted(await loadScene(`${name}.json`, { read: fetchText, url: (file) => urls[file] }));
}

/** Opens the scene among files that the reader chose or dropped: one JSON, the OBJ it names, and its picture. Throws SceneProblem. */
export async function openFiles(files: readonly File[]): Promise<Scene> {
  const json = files.find((file) => /\.json$/i.test(file.name));
  if (!json) throw new SceneProblem('page.errors.sceneNoJson', {});
  const named = (name: string) => files.find((file) => file.name === name);
  let missing = '';
  const read = await loadScene(json.name, {
    read: async (name) => named(name)?.text() ?? null,
    url: (name) => {
      const picture = named(name);
      if (!picture) missing = name;
      return picture ? URL.createObjectURL(picture) : null;
    },
  });
  const scene = trusted(read);
  if (missing) notify('info', 'page.notice.pictureMissing', { missing });
  scene.name = freeName(scene.name);
  keep(scene);
  return scene;
}

/** A name that a link can carry, and that leaves the library's own scenes reachable. */
function freeName(name: string): string {
  const plain = name.replace(/[^\w-]+/g, '-').slice(0, 50);
  return librarySceneNames.some((known) => known === plain) ? `${plain}-file` : plain;
}

/** Takes the place of an earlier scene of that name, whose picture is let go. */
function keep(scene: Scene): void {
  const same = openedScenes.value.find(({ name }) => name === scene.name);
  if (same?.texture) URL.revokeObjectURL(same.texture.url);
  openedScenes.value = [...openedScenes.value.filter((other) => other !== same), scene];
}

function trusted(result: Scene | SceneError): Scene {
  if (!isSceneError(result)) return result;
  throw new SceneProblem('page.errors.scene', { sentence: describeSceneError(result, sceneMessages()) });
}

async function fetchText(file: string): Promise<string | null> {
  try {
    const response = await fetch(urls[file]);
    return response.ok ? await response.text() : null;
  } catch {
    return null; // no network; the sentence that follows names the file
  }
}
