import type { MadeScene } from './made_scene.ts';

/** The smallest net that is more than a chain, upright, hung by one corner: small enough to write all its matrices out. */
export function triangle(): MadeScene {
  return {
    name: 'triangle',
    vertices: [
      [-0.4, 0, 0],
      [0.4, 0, 0],
      [0, -0.6, 0],
    ],
    shape: {
      springs: [
        [0, 1],
        [1, 2],
        [2, 0],
      ],
    },
    pinned: [0],
    k: 100,
    m: 0.5,
  };
}
