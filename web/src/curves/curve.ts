/** m, in the plane that is drawn on; x to the right, y up. */
export type Point2 = readonly [x: number, y: number];

/** One stroke of the pen. Where `closed`, it ends where it begins. */
export interface Stroke {
  from: number;
  to: number;
  /** Finite for every t from `from` to `to`. */
  at(t: number): Point2;
  /** Parameters where the direction jumps, besides the ends, ascending. */
  corners: readonly number[];
  closed: boolean;
}

export interface Curve {
  strokes: readonly Stroke[];
}

export function distance([ax, ay]: Point2, [bx, by]: Point2): number {
  return Math.hypot(bx - ax, by - ay);
}
