import type { Point3 } from '../../app/kinematics.ts';
import type { ArmCurve } from './arm_curve.ts';
import type { ArmMoment } from './arm_moment.ts';
import type { ArmPalette } from './arm_palette.ts';

/** Everything that is drawn of an arm. Nobody changes its arrays. */
export interface ArmPicture {
  /** #joints×3, m. */
  x: Float64Array;
  /** m. */
  root: Point3;
  /** #links, m. */
  lengths: readonly number[];
  /** m. */
  target: Point3;
  /** Null where only the pose matters. */
  moment: ArmMoment | null;
  curve: ArmCurve | null;
  /** How many of the curve's targets have been gone to. */
  place: number;
  /** What the pen on the floor is drawing: #×3, m. */
  stroke: Float64Array;
  pointedJoint: number | null;
  palette: ArmPalette;
}

/** m: of the stretched arm. */
export function reachIn({ lengths }: Pick<ArmPicture, 'lengths'>): number {
  return lengths.reduce((sum, length) => sum + length, 0);
}
