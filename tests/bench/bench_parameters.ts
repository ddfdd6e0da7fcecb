import type { Scene } from '../../web/src/scene/scene.ts';
import type { Parameters } from '../../web/src/solver/module.ts';
import { sceneParameters } from '../../web/src/solver/scene_parameters.ts';

/** Those of the scene, with the course's number of iterations whatever its own is: the yardstick is the same for all. */
export function benchParameters(scene: Scene): Parameters {
  return { ...sceneParameters(scene), iterations: 50 };
}
