import { type Curve, distance, type Point2, type Stroke } from './curve.ts';

/** A smooth stretch of a stroke, from corner to corner, in cells so small that in each t moves evenly along it. */
export interface Stretch {
  stroke: number;
  /** #C+1. Ascending. */
  t: number[];
  /** #C+1, m. Arc length up to each t. */
  length: number[];
  /** #C+1, rad. How far the direction has turned, all turns counted alike. */
  turn: number[];
}

const firstCells = 61; // a prime, so that they do not fall in step with the waves of a formula
const mostHalvings = 12;
/** Of the length: an error of 1e-6 in where t is. */
const unevenness = 4e-6;
/** Of the length: a chord this much shorter than two is an error of 1e-6 in the length. */
const bend = 3e-6;

/** Its smooth stretches, in the order in which they are drawn. */
export function measureCurve(curve: Curve): Stretch[] {
  return curve.strokes.flatMap((stroke, s) => {
    let stretches = known.get(stroke);
    if (!stretches) {
      const ends = [stroke.from, ...stroke.corners, stroke.to];
      stretches = ends.slice(1).map((to, i) => measure(stroke, ends[i] as number, to));
      known.set(stroke, stretches);
    }
    return stretches.map((stretch) => ({ ...stretch, stroke: s }));
  });
}

/** A reader moves the budget many times over the same strokes. */
const known = new WeakMap<Stroke, Omit<Stretch, 'stroke'>[]>();

function measure({ at }: Stroke, from: number, to: number): Omit<Stretch, 'stroke'> {
  const firstT = Array.from({ length: firstCells + 1 }, (_, k) => from + ((to - from) * k) / firstCells);
  const first = firstT.map(at);
  const roughLength = first.reduce((sum, point, k) => sum + (k > 0 ? distance(first[k - 1] as Point2, point) : 0), 0);

  const t = [from];
  const points = [first[0] as Point2];
  const refine = (t0: number, p0: Point2, t1: number, p1: Point2, halvings: number) => {
    const middle = (t0 + t1) / 2;
    const p = at(middle);
    const a = distance(p0, p);
    const b = distance(p, p1);
    const isFine = Math.abs(a - b) <= unevenness * roughLength && a + b - distance(p0, p1) <= bend * (a + b);
    if (halvings < mostHalvings && !isFine) {
      refine(t0, p0, middle, p, halvings + 1);
      refine(middle, p, t1, p1, halvings + 1);
    } else {
      t.push(middle, t1);
      points.push(p, p1);
    }
  };
  for (let k = 1; k <= firstCells; k++)
    refine(firstT[k - 1] as number, first[k - 1] as Point2, firstT[k] as number, first[k] as Point2, 0);
  return { t, ...lengthAndTurn(points) };
}

function lengthAndTurn(points: readonly Point2[]): Pick<Stretch, 'length' | 'turn'> {
  const chords = points.slice(1).map(([x, y], k): Point2 => {
    const [beforeX, beforeY] = points[k] as Point2;
    return [x - beforeX, y - beforeY];
  });
  // Between the chord of cell k and the next; the cells at the ends turn as their neighbours do.
  const bends = chords.slice(1).map((chord, k) => angleBetween(chords[k] as Point2, chord));
  const bendBehind = (k: number) => bends[Math.min(Math.max(k, 0), bends.length - 1)] as number;
  const length = [0];
  const turn = [0];
  for (const [k, chord] of chords.entries()) {
    length.push((length[k] as number) + Math.hypot(...chord));
    turn.push((turn[k] as number) + (bendBehind(k - 1) + bendBehind(k)) / 2); // the direction at a point is between its chords'
  }
  return { length, turn };
}

/** Zero where one of them has no direction. */
function angleBetween([ax, ay]: Point2, [bx, by]: Point2): number {
  return Math.abs(Math.atan2(ax * by - ay * bx, ax * bx + ay * by));
}
