import type { MadeScene } from './made_scene.ts';

/** Four vertices in a ring, hung by the upper two: the smallest net whose Q has zeros where its factor L has none. */
export function square(): MadeScene {
  return {
    name: 'square',
    vertices: [
      [-0.3, 0, 0],
      [0.3, 0, 0],
      [0.3, -0.6, 0],
      [-0.3, -0.6, 0],
    ],
    shape: {
      springs: [
        [0, 1],
        [1, 2],
        [2, 3],
        [3, 0],
      ],
    },
    pinned: [0, 1],
    k: 100,
    m: 0.5,
  };
}
