import type { Pull } from '../../solver/protocol.ts';

/** What a poke has taken hold of. */
export interface Grip {
  /** The nearest to the touch first. */
  vertices: Int32Array;
  /** #vertices×3, metres: where they were then. */
  from: Float64Array;
}

/** Every vertex towards where it was, moved by a vector in metres; `stiffness`: N/m of each spring. */
export function pullBy({ vertices, from }: Grip, by: ArrayLike<number>, stiffness: number): Pull {
  return { vertices, targets: from.map((value, at) => value + by[at % 3]), stiffness };
}

/** What a pull does to one net. */
interface PullOn {
  /** #3, metres: the mean of the vertices that are pulled, and that of where they are pulled to. */
  centre: Float64Array;
  handle: Float64Array;
  /** N: the size of the sum of all forces. */
  force: number;
}

/** `points` #V×3, metres. */
export function pullOn({ vertices, targets, stiffness }: Pull, points: Float64Array): PullOn {
  const centre = new Float64Array(3);
  const handle = new Float64Array(3);
  const count = vertices.length;
  for (let at = 0; at < 3 * count; at++) {
    centre[at % 3] += points[3 * vertices[Math.floor(at / 3)] + (at % 3)] / count;
    handle[at % 3] += targets[at] / count;
  }
  const force = stiffness * count * Math.hypot(handle[0] - centre[0], handle[1] - centre[1], handle[2] - centre[2]);
  return { centre, handle, force };
}

/** CSS pixels, of an arrow that shows where a pull of any size goes. */
const legibleArrow = 32;

/**
 * #3, metres: where the arrow of a pull ends, which is at the handle. But stiff springs are hardly longer than a pixel when the vertices have
 * followed, and would show no force: from one pixel on, the arrow is long enough to be seen, below it shrinks to nothing.
 */
export function arrowTip({ centre, handle }: Pick<PullOn, 'centre' | 'handle'>, pixelsPerMetre: number): Float64Array {
  const along = handle.map((value, axis) => value - centre[axis]);
  const pixels = Math.hypot(along[0], along[1], along[2]) * pixelsPerMetre;
  const stretch = pixels > legibleArrow ? 1 : legibleArrow / Math.max(1, pixels);
  return centre.map((value, axis) => value + stretch * along[axis]);
}
