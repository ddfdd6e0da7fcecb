import { add, cross, dot, scale, type Vector } from '../../../lib/vector.ts';

/** y with M y = b, by Cramer's rule, from the rows of a 3×3 matrix; null where it has no inverse. */
export function solve3([first, second, third]: readonly Vector[], b: Vector): Vector | null {
  const determinant = dot(first, cross(second, third));
  if (!(Math.abs(determinant) > 0)) return null;
  const adjugate = [cross(second, third), cross(third, first), cross(first, second)]; // its columns
  return scale(1 / determinant, adjugate.map((column, at) => scale(b[at], column)).reduce(add));
}
