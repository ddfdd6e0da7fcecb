import type { MadeScene, Point, Spring } from './made_scene.ts';

const legs = 16;
const levels = 12;
const height = 4; // m
const mastHeight = 0.6; // m
const narrowestHeight = 3; // m
const narrowestRadius = 0.35; // m
const flare = 0.4; // m of radius per m of height, far from the narrowest level

/**
 * A lattice tower on a hyperboloid: rings, each turned by half a step against the one below, struts between neighbouring rings, upright struts over two
 * (without them it would fold), and a mast.
 */
export function tower(): MadeScene {
  const vertices: Point[] = [];
  const springs: Spring[] = [];
  const at = (level: number, leg: number) => level * legs + (leg % legs);
  for (let level = 0; level <= levels; level++) {
    for (let leg = 0; leg < legs; leg++) {
      vertices.push(latticePoint(level, leg));
      if (level === 0) continue; // the feet are pinned: springs between them would do nothing
      springs.push([at(level, leg), at(level, leg + 1)]);
      springs.push([at(level - 1, leg), at(level, leg)], [at(level - 1, leg + 1), at(level, leg)]);
      if (level > 1) springs.push([at(level - 2, leg + 1), at(level, leg)]);
    }
  }
  const mast = vertices.push([0, height + mastHeight, 0]) - 1;
  for (let leg = 0; leg < legs; leg++) springs.push([at(levels, leg), mast]);
  return {
    name: 'tower',
    vertices,
    shape: { springs },
    pinned: Array.from({ length: legs }, (_, leg) => at(0, leg)),
    k: 2e5, // as soft as it can be without being blown over by the wind
    m: 1,
  };
}

function latticePoint(level: number, leg: number): Point {
  const angle = (2 * Math.PI * (leg + level / 2)) / legs;
  const y = (height * level) / levels;
  const radius = Math.hypot(narrowestRadius, flare * (y - narrowestHeight));
  return [radius * Math.sin(angle), y, radius * Math.cos(angle)];
}
