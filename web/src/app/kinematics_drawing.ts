import { type Curve, distance, type Point2 } from '../curves/curve.ts';
import type { SampledCurve } from '../curves/sample_curve.ts';
import type { Followed } from '../solver/follow_targets.ts';
import type { Point3 } from './kinematics.ts';

/** A curve as the arm draws it, one target a picture. */
export interface Drawing extends DrawingTargets {
  followed: Followed;
  /** m: how near was near enough. */
  epsilon: number;
}

export interface DrawingTargets {
  /** #T×3, m: the curve's points on the floor and, between strokes, places in the air. */
  targets: Float64Array;
  /** #T: which stroke of the curve each belongs to; −1 in the air. */
  strokes: Int32Array;
}

/** m: how high the pen is lifted between strokes. */
const lift = 0.1;
/** Between two strokes, however far apart. */
const mostInTheAir = 40;

/** Where a point of the curve lies: the plane y = 0, seen from above with y upwards. */
export function onFloor([x, y]: Point2): Point3 {
  return [x, 0, -y];
}

/** All targets in their order; closed strokes end where they began. In the air they are as far apart as on the curve on average, so that the arm moves as fast. */
export function drawingTargets(curve: Curve, sampled: SampledCurve): DrawingTargets {
  const drawn = curve.strokes.map(({ closed }, stroke) => pointsOf(sampled, stroke, closed));
  const gap = meanGap(drawn);
  const targets: Point3[] = [];
  const strokes: number[] = [];
  drawn.forEach((points, stroke) => {
    const before = drawn[stroke - 1]?.at(-1);
    const between = before ? throughTheAir(before, points[0], gap) : [];
    targets.push(...between, ...points.map(onFloor));
    strokes.push(...between.map(() => -1), ...points.map(() => stroke));
  });
  return { targets: Float64Array.from(targets.flat()), strokes: Int32Array.from(strokes) };
}

function pointsOf({ points, stroke }: SampledCurve, wanted: number, closed: boolean): Point2[] {
  const own = Array.from(stroke, (_, i): Point2 => [points[2 * i], points[2 * i + 1]]).filter(
    (_, i) => stroke[i] === wanted,
  );
  return closed ? [...own, own[0]] : own;
}

function throughTheAir(from: Point2, to: Point2, gap: number): Point3[] {
  const count = Math.min(mostInTheAir, Math.ceil(distance(from, to) / gap));
  return Array.from({ length: count - 1 }, (_, k) => {
    const share = (k + 1) / count;
    const [x, , z] = onFloor([from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]);
    return [x, lift * Math.sin(Math.PI * share), z];
  });
}

/** m. */
function meanGap(strokes: readonly (readonly Point2[])[]): number {
  const gaps = strokes.flatMap((points) => points.slice(1).map((point, i) => distance(points[i], point)));
  return gaps.reduce((sum, gap) => sum + gap, 0) / gaps.length;
}
