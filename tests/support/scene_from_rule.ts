import type { MadeScene } from '../../scenes/rules/made_scene.ts';
import { writtenScene } from '../../scenes/rules/written_scene.ts';
import { loadScene } from '../../web/src/scene/load_scene.ts';
import type { Scene } from '../../web/src/scene/scene.ts';
import { describeSceneError, isSceneError } from '../../web/src/scene/scene_error.ts';

/** A scene made by rule, written down and read again without a folder in between. */
export async function sceneFromRule(made: MadeScene): Promise<Scene> {
  const files = writtenScene(made);
  const scene = await loadScene(`${made.name}.json`, {
    read: async (name) => String(files.get(name)),
    url: () => null,
  });
  if (isSceneError(scene)) throw new Error(describeSceneError(scene));
  return scene;
}
