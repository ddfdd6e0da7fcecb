import { kinematicsLimits, type Link, type Point3, reachOf } from '../../app/kinematics.ts';
import type { Point2 } from '../../curves/curve.ts';

/** Where in the curve's plane a place of the floor is, or what lies above it. */
export function offFloor([x, , z]: Point3): Point2 {
  return [x, -z];
}

/** m: radii of the circles in which the floor cuts the sphere of what the arm can reach, and that of what is too near for it; null where they do not meet. */
export function reachOnFloor(links: readonly Link[], height: number): { outer: number | null; inner: number | null } {
  const reach = reachOf({ links });
  const hole = 2 * Math.max(...links.map(({ length }) => length)) - reach;
  const radius = (sphere: number) => (sphere > Math.abs(height) ? Math.sqrt(sphere ** 2 - height ** 2) : null);
  return { outer: radius(reach), inner: radius(hole) };
}

/** #(pieces+1)×3, m: around a point of the floor. */
export function circleOnFloor(x: number, z: number, radius: number, pieces: number): Float64Array {
  const points = new Float64Array(3 * (pieces + 1));
  for (let i = 0; i <= pieces; i++) {
    const angle = (2 * Math.PI * i) / pieces;
    points.set([x + radius * Math.cos(angle), 0, z + radius * Math.sin(angle)], 3 * i);
  }
  return points;
}

/**
 * #(pieces+1)×3, m: the arc of a radius about `centre` that turns the direction of `from` into that of `to` the short way. Where both point the same
 * way it is a point; where they are opposite no plane is the right one, and any will do.
 */
export function arcBetween(
  centre: ArrayLike<number>,
  from: ArrayLike<number>,
  to: ArrayLike<number>,
  radius: number,
  pieces: number,
): Float64Array {
  const a = direction(centre, from);
  const b = direction(centre, to);
  const cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const side = unit(b.map((value, axis) => value - cosine * a[axis])) ?? unit(across(a)) ?? a;
  const sine = side[0] * b[0] + side[1] * b[1] + side[2] * b[2];
  const angle = Math.atan2(sine, cosine);
  const points = new Float64Array(3 * (pieces + 1));
  for (let i = 0; i <= pieces; i++) {
    const turned = (angle * i) / pieces;
    for (const axis of [0, 1, 2])
      points[3 * i + axis] = centre[axis] + radius * (Math.cos(turned) * a[axis] + Math.sin(turned) * side[axis]);
  }
  return points;
}

export function distanceOf(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** Straight down where both are one point. */
function direction(from: ArrayLike<number>, to: ArrayLike<number>): number[] {
  return unit([to[0] - from[0], to[1] - from[1], to[2] - from[2]]) ?? [0, -1, 0];
}

/** Shorter than this, of what is made of unit vectors, is rounding. */
const rounding = 1e-12;

function unit(v: number[]): number[] | null {
  const length = Math.hypot(...v);
  return length > rounding ? v.map((value) => value / length) : null;
}

/** At right angles to a unit vector. */
function across([x, y, z]: number[]): number[] {
  return Math.abs(x) < 0.9 ? [0, z, -y] : [-z, 0, x];
}

/** A target that the app's state takes: to a tenth of a millimetre, and not farther away than it allows. */
export function rounded(point: ArrayLike<number>): Point3 {
  const { min, max } = kinematicsLimits.coordinate;
  const near = (value: number) => Math.round(1e4 * Math.min(max, Math.max(min, value))) / 1e4 + 0; // no −0
  return [near(point[0]), near(point[1]), near(point[2])];
}
