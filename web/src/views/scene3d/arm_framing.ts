import { reachOf } from '../../app/kinematics.ts';
import { reachOnFloor } from './arm_geometry.ts';
import type { ArmPicture } from './arm_picture.ts';
import type { Framing } from './framing.ts';

/** Radians from +y down, and about y from the front: floor and arm can both be read. */
const polar = 1.12;
const azimuth = 0.45;
/** Of the circle that the arm reaches on the floor. */
const shownFloor = 0.45;
/** Reaches from the root, from which on a target does not make everything else small. */
const farAway = 1.3;

/** The arm, the floor that it mostly works on, its curve, and a target that is not far off. */
export function homeFraming(picture: ArmPicture): Framing {
  const { root, target, curve } = picture;
  const far = Math.hypot(...target.map((value, axis) => value - root[axis])) > farAway * reachOf(picture);
  return framing(picture, [...(far ? [] : target), ...(curve?.targets ?? [])]);
}

/** Likewise with everything that is drawn. */
export function fullFraming(picture: ArmPicture): Framing {
  return framing(picture, [...picture.target, ...(picture.curve?.targets ?? [])]);
}

function framing(picture: ArmPicture, more: Iterable<number>): Framing {
  const { x, root, links } = picture;
  const reach = reachOf(picture);
  const radius = shownFloor * (reachOnFloor(links, root[1]).outer ?? reach);
  const corners = [0, 1, 2, 3].flatMap((quarter) => {
    const angle = (Math.PI / 2) * quarter;
    return [root[0] + radius * Math.cos(angle), 0, root[2] + radius * Math.sin(angle)];
  });
  const above = [root[0], root[1] + 0.1 * reach, root[2]];
  return { points: Float64Array.from([...x, ...above, ...corners, ...more]), polar, azimuth };
}
