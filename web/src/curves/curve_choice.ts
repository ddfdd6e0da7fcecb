import type { Point2 } from './curve.ts';

/** What can be drawn, as a link carries it: plain JSON. */
export type CurveChoice =
  | { kind: 'circle' | 'square' | 'heart' | 'triangle' | 'star' }
  | { kind: 'letters'; text: string }
  /** x(t) and y(t), m, from one t to another: expressions, the ends too. */
  | { kind: 'formula'; x: string; y: string; from: string; to: string }
  /** Drawn by hand: m. */
  | { kind: 'hand'; strokes: readonly (readonly Point2[])[] }
  /** The `d` of an SVG path. */
  | { kind: 'path'; d: string };
