import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { SceneSource } from '../src/scene/load_scene.ts';

/** Scenes of a folder on disk. Pictures are not opened: nothing here looks at them. */
export function folderSource(folder: string): SceneSource {
  return {
    read: (name) => readFile(join(folder, name), 'utf8').catch(() => null),
    url: (name) => pathToFileURL(join(folder, name)).href,
  };
}
