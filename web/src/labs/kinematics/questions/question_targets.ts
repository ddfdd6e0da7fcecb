import { onFloor } from '../../../app/kinematics_drawing.ts';
import { shape } from '../../../curves/shape.ts';

/** The curves that the questions are asked along. */
export const questionCurves = ['circle', 'heart'] as const;
export type QuestionCurve = (typeof questionCurves)[number];

/** #T×3, m: so many targets on the floor, evenly in the curve's parameter. [P] */
export function questionTargets(curve: QuestionCurve, count: number): Float64Array {
  const { from, to, at } = shape(curve);
  const targets = Array.from({ length: count }, (_, step) => onFloor(at(from + ((to - from) * step) / count)));
  return Float64Array.from(targets.flat());
}
