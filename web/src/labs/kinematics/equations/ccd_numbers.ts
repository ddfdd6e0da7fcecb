import type { Search } from '../../../app/kinematics_session.ts';
import { axisAngle, conjugate, multiply, quaternionAt } from '../../../lib/quaternion.ts';
import { cross, dot, norm, row, scale, subtract, type Vector } from '../../../lib/vector.ts';
import type { Moment } from '../trace/moment.ts';

/** What CCD does with one joint. */
export interface CcdNumbers {
  joint: number;
  /** #3, m: from the joint to the end effector before it turned, and to the target. */
  toEffector: Vector;
  toTarget: Vector;
  /** rad: between both. */
  theta: number;
  /** #3, of length 1, in the world; null where both point the same way, or opposite ways. */
  axis: Vector | null;
  /** rad: by how much the joint has turned in fact. */
  turned: number;
  /** Why that is less than θ; null where it is not. */
  short: 'held' | 'rounded' | null;
}

/** rad: a difference that only a limit makes. */
const held = 1e-5;
/** rad: in single precision the cosine of less is 1 but for its last bits. */
const unknown = 1e-3;

/** Of the joint that has turned last; null where that was no joint alone. */
export function ccdNumbers({ task }: Search, { joint, before, after }: Moment): CcdNumbers | null {
  if (joint === null) return null;
  const x = row(before.x, joint);
  const toEffector = subtract(row(before.x, before.x.length / 3 - 1), x);
  const toTarget = subtract(row(task.target, 0), x);
  const across = cross(toEffector, toTarget);
  const sine = norm(across);
  const { angle: turned } = axisAngle(multiply(conjugate(quaternionAt(before.q, joint)), quaternionAt(after.q, joint)));
  const theta = Math.atan2(sine, dot(toEffector, toTarget));
  const rounded = task.precision === 'single' && theta < unknown && turned < theta / 2;
  return {
    joint,
    toEffector,
    toTarget,
    theta,
    axis: sine > 0 ? scale(1 / sine, across) : null,
    turned,
    short: rounded ? 'rounded' : theta - turned > held ? 'held' : null,
  };
}
