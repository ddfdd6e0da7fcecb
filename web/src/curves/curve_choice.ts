import type { Point2 } from './curve.ts';

export const shapes = ['circle', 'square', 'heart', 'triangle', 'star'] as const;
export type Shape = (typeof shapes)[number];

/** Characters; and the points that ends and corners of a path may demand, which are no more than a reader may ask for. */
export const curveLimits = { letters: 24, formula: 200, path: 20_000, points: { min: 8, max: 1000 } } as const;

/** What the reader wants drawn: plain JSON, as a link carries it. `curveFrom` makes a curve of it. */
export type CurveChoice =
  | { kind: Shape }
  | { kind: 'letters'; text: string }
  /** x(t) and y(t) in m, for t between two expressions without t: "0", "2 pi". */
  | { kind: 'formula'; x: string; y: string; from: string; to: string }
  | { kind: 'hand'; strokes: readonly (readonly Point2[])[] }
  /** SVG path data, or markup that contains some. */
  | { kind: 'path'; d: string };
