import { signal } from '@preact/signals';
import type { Scene } from '../scene/scene.ts';
import { describeSceneError, isSceneError, type SceneError } from '../scene/scene_error.ts';
import { sceneMessages } from './messages/index.ts';
import { notify } from './notices.ts';
import { readScene } from './read_scene.ts';
import { SceneProblem } from './scene_problem.ts';

/** Addresses of the scenes' files as built, by file name. */
const urls = Object.fromEntries(
  Object.entries(
    import.meta.glob<string>(['../../../scenes/*.{json,obj,mesh,png}', '!../../../scenes/*.schema.json'], {
      query: '?url',
      import: 'default',
      eager: true,
    }),
  ).map(([path, url]) => [path.slice(path.lastIndexOf('/') + 1), url]),
);

/** In the order of the lesson, one idea more each time; then the cloth and the solids that integrators are compared on. */
export const librarySceneNames = [
  'single-spring-horizontal',
  'triangle',
  'square',
  'horizontal-chain',
  'patch',
  'net',
  'tower',
  'flag',
  'skirt',
  'cloth',
  'rabbit',
  'rabbit-fine',
] as const;

/** Scenes that the reader opened from files, for this visit. */
export const openedScenes = signal<Scene[]>([]);

/** The scene of that name, opened from files or else of the library. Throws SceneProblem, or the signal's reason. */
export async function findScene(name: string, signal?: AbortSignal): Promise<Scene> {
  const opened = openedScenes.value.find((scene) => scene.name === name);
  if (opened) return opened;
  if (!librarySceneNames.some((known) => known === name)) throw new SceneProblem('page.errors.sceneUnknown', { name });
  return trusted((await readScene(`${name}.json`, urls, signal)).result);
}

/** Opens the scene among files that the reader chose or dropped: one JSON and the files it names, or a mesh alone. Throws SceneProblem, or the signal's reason. */
export async function openFiles(files: readonly File[], signal: AbortSignal): Promise<Scene> {
  const first = ['.json', '.mesh'].flatMap((end) => files.filter(({ name }) => name.toLowerCase().endsWith(end)))[0];
  if (!first) throw new SceneProblem('page.errors.sceneNoJson', {});
  const addresses = Object.fromEntries(files.map((file) => [file.name, URL.createObjectURL(file)]));
  let picture: string | undefined;
  try {
    const { result, missingPicture } = await readScene(first.name, addresses, signal);
    const scene = trusted(result);
    if (missingPicture) notify('info', 'page.notice.pictureMissing', { missing: missingPicture });
    scene.name = freeName(scene.name);
    picture = scene.texture?.url;
    keep(scene);
    return scene;
  } finally {
    for (const address of Object.values(addresses)) if (address !== picture) URL.revokeObjectURL(address);
  }
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
