import type { Point3 } from '../../app/kinematics.ts';
import type { Camera } from '../../app/state.ts';
import type { Point2 } from '../../curves/curve.ts';
import { directionOf } from './arrow_keys.ts';
import { screenAxes } from './screen_axes.ts';

type Press = Pick<KeyboardEvent, 'key' | 'shiftKey'>;

/** m; ten times as much with Shift. */
const stride = 0.01;
const strideOf = ({ shiftKey }: Press) => stride * (shiftKey ? 10 : 1);

/** m, as the reader sees it: arrows move in the plane of the screen, Page Up away from the eye, Page Down towards it. Null for other keys. */
export function spaceMove(press: Press, camera: Camera): Point3 | null {
  const direction = directionOf(press.key);
  const depth = press.key === 'PageUp' ? 1 : press.key === 'PageDown' ? -1 : 0;
  if (!direction && depth === 0) return null;
  const { right, up } = screenAxes(camera);
  const away = [0, 1, 2].map((axis) => camera.target[axis] - camera.position[axis]);
  const distance = Math.hypot(...away);
  const by = (axis: number) =>
    strideOf(press) *
    (direction ? direction[0] * right[axis] + direction[1] * up[axis] : (depth * away[axis]) / distance);
  return [by(0), by(1), by(2)];
}

/** m, in the curve's plane: arrows move along its axes, whichever come nearest to what the reader sees as right and away. Null for other keys. */
export function floorMove(press: Press, camera: Camera): Point2 | null {
  const direction = directionOf(press.key);
  if (!direction) return null;
  const { right } = screenAxes(camera);
  const [alongX, alongY] = [right[0], -right[2]];
  const [rightX, rightY] = Math.abs(alongX) >= Math.abs(alongY) ? [Math.sign(alongX), 0] : [0, Math.sign(alongY)];
  const [across, ahead] = direction.map((value) => value * strideOf(press));
  return [across * rightX - ahead * rightY, across * rightY + ahead * rightX];
}
