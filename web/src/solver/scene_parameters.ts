import type { Scene } from '../scene/scene.ts';
import type { MinimisingParameters } from './module.ts';

/** The parameters of a scene as its file gives them, and where it gives none those of the course: gravity 9.8 m/s², no wind. */
export function sceneParameters({ k, delta_t, w, iterations }: Scene): MinimisingParameters {
  return {
    k,
    delta_t,
    w,
    iterations,
    method: 'local-global',
    stop_gradient: 0,
    stop_decrease: 0,
    mass_scale: 1,
    gravity: 9.8,
    damping: 0,
    wind: false,
    path: 'fast',
    storage: 'sparse',
  };
}
