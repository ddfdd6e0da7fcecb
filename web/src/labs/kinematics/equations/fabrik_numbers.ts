import type { Search } from '../../../app/kinematics_session.ts';
import { axisAngle, conjugate, multiply, quaternionAt } from '../../../lib/quaternion.ts';
import { norm, row, subtract, type Vector } from '../../../lib/vector.ts';
import type { Moment } from '../trace/moment.ts';

/** What a pass of FABRIK does with one joint. */
export interface PassRow {
  joint: number;
  /** #3, m: where the pass puts it. */
  x: Vector;
  /** m: how far that is from where it was. */
  moved: number;
  /** rad: by how much its own rotation changed for the new positions; null on the way backward, which knows only positions, and at the end effector, which turns nothing. */
  turned: number | null;
}

/** The joints in the order of the pass, or of what limits made of it: from the end effector to the root, or from the root on. */
export function passRows({ before, after, kind }: Moment): PassRow[] {
  const joints = after.x.length / 3;
  const rows = Array.from({ length: joints }, (_, joint) => ({
    joint,
    x: row(after.x, joint),
    moved: norm(subtract(row(after.x, joint), row(before.x, joint))),
    turned: kind === 'backward' || joint === joints - 1 ? null : turnOf(before.q, after.q, joint),
  }));
  return kind === 'backward' ? rows.reverse() : rows;
}

/** m: how far the backward pass has pulled the root away. */
export function rootGap({ task }: Search, { after }: Moment): number {
  return norm(subtract(row(after.x, 0), row(task.root, 0)));
}

function turnOf(before: Float64Array, after: Float64Array, joint: number): number {
  return axisAngle(multiply(conjugate(quaternionAt(before, joint)), quaternionAt(after, joint))).angle;
}
