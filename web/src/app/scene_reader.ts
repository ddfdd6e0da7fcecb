import { expose, transfer } from 'comlink';
import { loadScene } from '../scene/load_scene.ts';
import type { Scene } from '../scene/scene.ts';
import { isSceneError, type SceneError } from '../scene/scene_error.ts';

/** What came of reading a scene. */
export interface SceneReading {
  result: Scene | SceneError;
  /** The picture that the scene names, if it is not there; empty otherwise. */
  missingPicture: string;
}

/** Reads the scene whose JSON, or mesh without one, is `file`. `addresses`: of that file and those it names, by name. */
async function read(file: string, addresses: Record<string, string>): Promise<SceneReading> {
  let missingPicture = '';
  const result = await loadScene(file, {
    read: (name) => fetchText(addresses[name]),
    url: (name) => {
      if (!(name in addresses)) missingPicture = name;
      return addresses[name] ?? null;
    },
  });
  const reading = { result, missingPicture };
  return isSceneError(result) ? reading : transfer(reading, buffersOf(result));
}

async function fetchText(address: string | undefined): Promise<string | null> {
  if (address === undefined) return null;
  try {
    const response = await fetch(address);
    return response.ok ? await response.text() : null;
  } catch {
    return null; // no network; the sentence that follows names the file
  }
}

function buffersOf({ V, E, F, m, pinned, texture }: Scene): ArrayBufferLike[] {
  const arrays = [V, E, F, m, pinned, ...(texture ? [texture.VT, texture.FT] : [])];
  return arrays.map(({ buffer }) => buffer);
}

export type ReadScene = typeof read;
expose(read);
