import type { Link, Point3 } from '../../app/kinematics.ts';
import type { ArmCurve } from './arm_curve.ts';
import type { ArmMoment } from './arm_moment.ts';
import type { ArmPalette } from './arm_palette.ts';

/** Everything that is drawn of an arm. Nobody changes its parts: what is the same thing in the next picture has not changed. */
export interface ArmPicture {
  /** #joints×3, m. */
  x: Float64Array;
  /** m. */
  root: Point3;
  links: readonly Link[];
  /** m. */
  target: Point3;
  /** Null where only the pose matters. */
  moment: ArmMoment | null;
  curve: ArmCurve | null;
  /** The target of the drawing that the arm is at. */
  place: number;
  /** What the pen on the floor is drawing: #×3, m. */
  stroke: Float64Array;
  pointedJoint: number | null;
  palette: ArmPalette;
}
