import { distance, type Point2, type Stroke } from './curve.ts';

/** Control points of a Bézier curve: two of a line, three of a parabola, four of a cubic. */
export type Piece = readonly Point2[];

/** A turn below 5° between two pieces is taken for rounding in a file whose author meant none. */
const smallestCorner = (5 * Math.PI) / 180;

/** The stroke along `pieces`, at least one and each of some extent: piece k from t = k to k + 1. */
export function bezierStroke(pieces: readonly Piece[], closed: boolean): Stroke {
  const corners = pieces
    .map((_, k) => k)
    .filter((k) => k > 0 && turnBetween(pieces[k - 1] as Piece, pieces[k] as Piece) > smallestCorner);
  return {
    from: 0,
    to: pieces.length,
    at(t) {
      const k = Math.min(Math.floor(t), pieces.length - 1);
      return pointOf(pieces[k] as Piece, t - k);
    },
    corners,
    closed,
  };
}

/** By de Casteljau's construction. */
function pointOf(piece: Piece, t: number): Point2 {
  if (piece.length === 1) return piece[0] as Point2;
  return pointOf(
    piece.slice(1).map((point, i) => between(piece[i] as Point2, point, t)),
    t,
  );
}

function between([ax, ay]: Point2, [bx, by]: Point2, t: number): Point2 {
  return [ax + (bx - ax) * t, ay + (by - ay) * t];
}

/** Angle from the end of one piece to the start of the next, 0 to π. */
function turnBetween(before: Piece, after: Piece): number {
  const [ax, ay] = direction([...before].reverse());
  const [bx, by] = direction(after);
  // The first was taken against its sense.
  return Math.abs(Math.atan2(ay * bx - ax * by, -ax * bx - ay * by));
}

/** From the first control point to the next that is elsewhere. */
function direction([start, ...others]: Piece): Point2 {
  const from = start as Point2;
  const to = others.find((point) => distance(from, point) > 0) as Point2;
  return [to[0] - from[0], to[1] - from[1]];
}

/** From the first control point to that farthest from it. */
export function extentOf([start, ...others]: Piece): number {
  return Math.max(...others.map((point) => distance(start as Point2, point)));
}

/** The stroke that joins `points` by lines; a closed one returns to the first. */
export function polyline(points: readonly Point2[], closed: boolean): Stroke {
  const round = closed ? [...points, points[0] as Point2] : points;
  return bezierStroke(
    round.slice(1).map((point, i) => [round[i] as Point2, point]),
    closed,
  );
}
