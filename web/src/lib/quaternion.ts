import { dot, norm, scale, type Vector } from './vector.ts';

/** A rotation: #4, (x, y, z, w), of length 1. */
export type Quaternion = readonly [x: number, y: number, z: number, w: number];

/** Row i of a row-major #×4 array. */
export function quaternionAt(list: Float64Array, i: number): Quaternion {
  return [list[4 * i], list[4 * i + 1], list[4 * i + 2], list[4 * i + 3]];
}

/** First b, then a. */
export function multiply([ax, ay, az, aw]: Quaternion, [bx, by, bz, bw]: Quaternion): Quaternion {
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}

/** The rotation back. */
export function conjugate([x, y, z, w]: Quaternion): Quaternion {
  return [-x, -y, -z, w];
}

/** Rows of the 3×3 matrix that turns vectors likewise. */
export function matrixOf([x, y, z, w]: Quaternion): readonly [Vector, Vector, Vector] {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
  ];
}

export function rotate(q: Quaternion, v: Vector): Vector {
  return matrixOf(q).map((line) => dot(line, v));
}

/** The axis, of length 1, and the angle, 0 … π; no axis where nothing turns. q and −q turn alike, the shorter way. */
export function axisAngle([x, y, z, w]: Quaternion): { axis: Vector | null; angle: number } {
  const sine = norm([x, y, z]);
  if (sine === 0) return { axis: null, angle: 0 };
  return { axis: scale((w < 0 ? -1 : 1) / sine, [x, y, z]), angle: 2 * Math.atan2(sine, Math.abs(w)) };
}

/** Axis times angle, rad; 0 where nothing turns. */
export function rotationVector(q: Quaternion): Vector {
  const { axis, angle } = axisAngle(q);
  return axis ? scale(angle, axis) : [0, 0, 0];
}
