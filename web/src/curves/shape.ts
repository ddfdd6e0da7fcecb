import { polyline } from './bezier_stroke.ts';
import type { Point2, Stroke } from './curve.ts';
import type { Shape } from './curve_choice.ts';

const turn = 2 * Math.PI;

function polar(angle: number, radius: number): Point2 {
  return [radius * Math.cos(angle), radius * Math.sin(angle)];
}

/** The lab's five shapes; lengths in m. */
export function shape(kind: Shape): Stroke {
  switch (kind) {
    case 'circle':
      return { from: 0, to: turn, at: (t) => polar(t, 0.6), corners: [], closed: true };
    case 'square': // of side 0.4
      return polyline(
        [
          [-0.2, -0.2],
          [0.2, -0.2],
          [0.2, 0.2],
          [-0.2, 0.2],
        ],
        true,
      );
    case 'heart': // begins in its cusp, so that the only jump of direction is at the ends
      return {
        from: turn / 4,
        to: turn / 4 + turn,
        at: (t) => polar(t, 0.5 * (1 - Math.sin(t))),
        corners: [],
        closed: true,
      };
    case 'triangle': // with legs of 0.5
      return polyline(
        [
          [-0.25, -0.25],
          [0.25, -0.25],
          [-0.25, 0.25],
        ],
        true,
      );
    case 'star': // five lines from every point to the next but one
      return polyline(
        [0, 2, 4, 6, 8].map((k) => polar(turn / 4 + (k * turn) / 5, 0.4)),
        true,
      );
  }
}
