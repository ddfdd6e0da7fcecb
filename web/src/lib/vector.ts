/** #3: x, y, z. */
export type Vector = readonly number[];

/** Row i of a row-major #×3 array. */
export function row(matrix: Float64Array, i: number): Vector {
  return Array.from(matrix.subarray(3 * i, 3 * i + 3));
}

export function subtract(a: Vector, b: Vector): Vector {
  return a.map((value, axis) => value - (b[axis] as number));
}

export function add(a: Vector, b: Vector): Vector {
  return a.map((value, axis) => value + (b[axis] as number));
}

export function scale(factor: number, a: Vector): Vector {
  return a.map((value) => factor * value);
}

export function dot(a: Vector, b: Vector): number {
  return a.reduce((sum, value, axis) => sum + value * (b[axis] as number), 0);
}

export function cross([ax, ay, az]: Vector, [bx, by, bz]: Vector): Vector {
  return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
}

export function norm(a: Vector): number {
  return Math.hypot(...a);
}
