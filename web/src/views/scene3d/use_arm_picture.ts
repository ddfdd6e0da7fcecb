import { type ReadonlySignal, useComputed } from '@preact/signals';
import { useRef } from 'preact/hooks';
import type { Point3 } from '../../app/kinematics.ts';
import { onFloor } from '../../app/kinematics_drawing.ts';
import type { KinematicsSession, Search } from '../../app/kinematics_session.ts';
import { pointedJoint } from '../../app/pointed_joint.ts';
import { countEvents } from '../../app/pose.ts';
import { appliedTheme } from '../../app/preferences.ts';
import { state } from '../../app/state.ts';
import { armCurveOf } from './arm_curve.ts';
import { type ArmMoment, momentOf } from './arm_moment.ts';
import { darkArmPalette, lightArmPalette } from './arm_palette.ts';
import type { ArmPicture } from './arm_picture.ts';
import type { FloorPen } from './floor_pen.ts';

/** What is drawn now; null before the first search. */
export function useArmPicture(session: KinematicsSession, pen: FloorPen): ReadonlySignal<ArmPicture | null> {
  const moment = useMoment(session);
  const target = useComputed(() => targetNow(session));
  const stroke = useComputed(() => Float64Array.from(pen.stroke.value.flatMap(onFloor)));
  const curve = useComputed(() => session.drawing.value && armCurveOf(session.drawing.value));
  return useComputed(() => {
    const { value: pose } = session.pose;
    if (!pose) return null;
    const { root, links } = state.value.kinematics;
    return {
      x: pose.x,
      root,
      links,
      target: target.value,
      moment: moment.value,
      curve: curve.value,
      place: session.place.value,
      stroke: stroke.value,
      pointedJoint: pointedJoint.value,
      palette: appliedTheme.value === 'dark' ? darkArmPalette : lightArmPalette,
    };
  });
}

/** m: the reader's or, while a curve is drawn, the one that the arm is at. */
function targetNow({ drawing, place }: KinematicsSession): Point3 {
  if (!drawing.value) return state.value.kinematics.target;
  const [x, y, z] = drawing.value.targets.subarray(3 * place.value, 3 * place.value + 3);
  return [x, y, z];
}

/** Null at the end of a search, unless its events were gone through. */
function useMoment({ search, event, playing }: KinematicsSession): ReadonlySignal<ArmMoment | null> {
  const steppedIn = useRef<Search | null>(null);
  return useComputed(() => {
    const { value: now } = search;
    const { value: at } = event;
    if (!now || playing.value) return null;
    if (at < countEvents(now.answer)) steppedIn.current = now;
    return steppedIn.current === now ? momentOf(now, at) : null;
  });
}
