import type { Scene } from '../scene/scene.ts';
import type { MinimisingParameters } from './module.ts';

/** The parameters of a scene, and what scenes do not say: no wind, the paper's method. */
export function sceneParameters({ k, delta_t, w, iterations, gravity, damping }: Scene): MinimisingParameters {
  return {
    k,
    delta_t,
    w,
    iterations,
    method: 'local-global',
    stop_gradient: 0,
    stop_decrease: 0,
    mass_scale: 1,
    gravity,
    damping,
    wind: false,
    path: 'fast',
    storage: 'sparse',
  };
}
