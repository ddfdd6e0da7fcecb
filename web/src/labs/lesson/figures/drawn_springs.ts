import type { Scene } from '../../../scene/scene.ts';
import type { Frame } from '../../../solver/frame.ts';
import type { HalfStep } from './use_half_step.ts';

/** The p that the projection d belongs to: after a global step p has moved on. */
export function projectedFrom({ phase, p, pBefore }: Frame): Float64Array {
  return phase === 'global' || phase === 'accept' ? pBefore : p;
}

/** #V×3, m: where the vertices are drawn while a global step moves them. */
export function netPositions({ frame: { phase, p, pBefore }, progress }: HalfStep): Float64Array {
  return phase === 'global' ? between(pBefore, p, progress) : p;
}

/** #E×2 points, m, as 2#E×3: both ends of every spring as it lies in the net. */
export function netEnds({ E }: Scene, p: Float64Array): Float64Array {
  const ends = new Float64Array(3 * E.length);
  for (const [end, i] of E.entries()) ends.set(p.subarray(3 * i, 3 * i + 3), 3 * end);
  return ends;
}

/** The same for springs torn from the net: each d about the middle of where the spring was. Before there is a d, the net. */
export function tornEnds(scene: Scene, { frame, progress }: HalfStep): Float64Array {
  const net = netEnds(scene, projectedFrom(frame));
  const { d } = frame;
  if (!d) return net;
  const ends = net.slice();
  for (let e = 0; e < d.length / 3; e++) {
    for (let axis = 0; axis < 3; axis++) {
      const middle = (ends[6 * e + axis] + ends[6 * e + 3 + axis]) / 2;
      ends[6 * e + axis] = middle + d[3 * e + axis] / 2;
      ends[6 * e + 3 + axis] = middle - d[3 * e + axis] / 2;
    }
  }
  return frame.phase === 'local' ? between(net, ends, progress) : ends;
}

function between(from: Float64Array, to: Float64Array, progress: number): Float64Array {
  return progress === 1 ? to : to.map((x, at) => from[at] + progress * (x - from[at]));
}

/** (length − r)/r of the spring between two ends; 0 for one that rests at length zero. */
export function strain(ends: Float64Array, e: number, r: Float64Array): number {
  const length = Math.hypot(...[0, 1, 2].map((axis) => ends[6 * e + axis] - ends[6 * e + 3 + axis]));
  return r[e] > 0 ? length / r[e] - 1 : 0;
}
