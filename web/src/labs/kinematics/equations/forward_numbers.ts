import type { Search } from '../../../app/kinematics_session.ts';
import type { Pose } from '../../../app/pose.ts';
import { axisAngle, matrixOf, multiply, type Quaternion, quaternionAt } from '../../../lib/quaternion.ts';
import { norm, row, subtract, type Vector } from '../../../lib/vector.ts';

/** What forward kinematics makes of one joint. */
export interface JointNumbers {
  /** #3, m. */
  x: Vector;
  /** ‖o_i‖, m: of the link that leads here; null at the root, where none does. */
  length: number | null;
  /** x_i − x_{i−1} = R_{i−1} o_i, m; likewise. */
  link: Vector | null;
  /** Of q_i: rad, and the axis, of length 1, as the joint before sees it; none where nothing turns. */
  angle: number;
  axis: Vector | null;
  /** Rows of R_i. */
  R: readonly [Vector, Vector, Vector];
}

/** Of every joint: x as the pose says it, R_i = R_{i−1} q_i. */
export function forwardNumbers({ task }: Search, { x, q }: Pose): JointNumbers[] {
  const numbers: JointNumbers[] = [];
  let R: Quaternion = [0, 0, 0, 1];
  for (let i = 0; i < x.length / 3; i++) {
    const own = quaternionAt(q, i);
    R = multiply(R, own);
    numbers.push({
      x: row(x, i),
      length: i === 0 ? null : norm(row(task.offsets, i - 1)),
      link: i === 0 ? null : subtract(row(x, i), row(x, i - 1)),
      ...axisAngle(own),
      R: matrixOf(R),
    });
  }
  return numbers;
}
