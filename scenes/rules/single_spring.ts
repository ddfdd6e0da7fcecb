import type { MadeScene } from './made_scene.ts';

/** One metre of spring, held at its left end. Soft, so that the swinging mass is seen to stretch it. */
export function singleSpring(): MadeScene {
  return {
    name: 'single-spring-horizontal',
    vertices: [
      [-0.5, 0, 0],
      [0.5, 0, 0],
    ],
    shape: { springs: [[0, 1]] },
    pinned: [0],
    k: 100,
    m: 1,
  };
}
