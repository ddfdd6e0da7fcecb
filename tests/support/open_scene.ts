import { join } from 'node:path';
import { folderSource } from '../../web/headless/folder_source.ts';
import { loadScene } from '../../web/src/scene/load_scene.ts';
import type { Scene } from '../../web/src/scene/scene.ts';
import { describeSceneError, isSceneError } from '../../web/src/scene/scene_error.ts';

/** A scene of scenes/, by its name. */
export async function openScene(name: string): Promise<Scene> {
  const scene = await loadScene(`${name}.json`, folderSource(join(import.meta.dirname, '../../scenes')));
  if (isSceneError(scene)) throw new Error(describeSceneError(scene));
  return scene;
}
