/** #3: x, y, z. */
export type Vector = readonly number[];

/** Row i of a row-major #×3 array. */
export function row(matrix: Float64Array, i: number): Vector {
  return Array.from(matrix.subarray(3 * i, 3 * i + 3));
}

export function subtract(a: Vector, b: Vector): Vector {
  return a.map((value, axis) => value - (b[axis] as number));
}

export function norm(a: Vector): number {
  return Math.hypot(...a);
}
