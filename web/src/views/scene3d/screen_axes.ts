import type { Camera } from '../../app/state.ts';

type Vector = [number, number, number];

/** m: of the box around #V×3 points. */
export function diagonal(V: Float64Array): number {
  const low = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
  const high = [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let at = 0; at < V.length; at++) {
    low[at % 3] = Math.min(low[at % 3], V[at]);
    high[at % 3] = Math.max(high[at % 3], V[at]);
  }
  return Math.hypot(...high.map((value, axis) => value - low[axis]));
}

/** Unit vectors in the world that point right and up on the screen. The camera's up is +y. */
export function screenAxes({ position, target }: Camera): { right: Vector; up: Vector } {
  const forward = normalised([0, 1, 2].map((axis) => target[axis] - position[axis]) as Vector);
  const right = normalised(cross(forward, [0, 1, 0]));
  return { right, up: cross(right, forward) };
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function normalised(v: Vector): Vector {
  const length = Math.hypot(...v);
  return v.map((x) => x / length) as Vector;
}
