import type { MadeScene, Point, Spring } from './made_scene.ts';

const count = 10;
const length = 1.8; // m

/** A straight chain between two pins, which sags by nearly a third of its length. */
export function chain(): MadeScene {
  const vertices = Array.from({ length: count }, (_, i): Point => [length * (i / (count - 1) - 0.5), 0, 0]);
  return {
    name: 'horizontal-chain',
    vertices,
    shape: { springs: vertices.slice(1).map((_, i): Spring => [i, i + 1]) },
    pinned: [0, count - 1],
    k: 1000,
    m: 1,
  };
}
