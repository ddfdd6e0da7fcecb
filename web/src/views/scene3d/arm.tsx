import { type ReadonlySignal, useComputed, useSignal, useSignalEffect } from '@preact/signals';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { reachOf } from '../../app/kinematics.ts';
import type { KinematicsSession, Search } from '../../app/kinematics_session.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { notify } from '../../app/notices.ts';
import { pointedJoint } from '../../app/pointed_joint.ts';
import { countEvents } from '../../app/pose.ts';
import { appliedTheme } from '../../app/preferences.ts';
import { state } from '../../app/state.ts';
import { fillTemplate } from '../../lib/fill_template.ts';
import { formatQuantity } from '../../lib/format.ts';
import { en } from './arm_en.ts';
import { gridStepOf } from './arm_floor.ts';
import { offFloor, onFloor, rounded } from './arm_geometry.ts';
import { ArmHandle } from './arm_handle.tsx';
import { floorMove, spaceMove } from './arm_keys.ts';
import { ArmLabels } from './arm_labels.tsx';
import { type ArmMoment, momentOf } from './arm_moment.ts';
import { darkArmPalette, lightArmPalette } from './arm_palette.ts';
import type { ArmPicture } from './arm_picture.ts';
import { ArmPointers } from './arm_pointers.ts';
import { ArmTools } from './arm_tools.tsx';
import { penText, targetText } from './arm_words.ts';
import { zh } from './arm_zh.ts';
import { Arm3D } from './arm3d.ts';
import { type FloorPen, strokesNow } from './floor_pen.ts';
import { QuietLine } from './quiet_line.tsx';
import './arm.css';

interface Props {
  session: KinematicsSession;
  actions: Actions;
  pen: FloorPen;
}

/** The arm in 3D: what it does is seen, its target moved, and a curve drawn for it by hand. */
export function Arm({ session, actions, pen }: Props) {
  const words = inLanguage({ en, zh });
  const canvas = useRef<HTMLCanvasElement>(null);
  const shown = useSignal<Arm3D | null>(null);
  const pictures = useSignal(0);
  const aim = useMemo(() => aimOncePerFrame(actions), [actions]);
  const picture = usePicture(session, pen);

  useEffect(() => {
    const element = canvas.current as HTMLCanvasElement;
    let drawing = 0;
    const draw = () => {
      drawing = 0;
      arm.render();
      pictures.value++;
    };
    const arm = new Arm3D(element, {
      onInvalidate: () => {
        drawing ||= requestAnimationFrame(draw);
      },
      onContextLost: () => notify('error', 'page.errors.contextLost'),
    });
    const pointers = new ArmPointers(element, arm, {
      onTarget: aim,
      onJoint: (joint) => {
        pointedJoint.value = joint;
      },
      mayDraw: () => pen.on.value,
      onPen: (place) => pen.draw(offFloor(place)),
      onPenUp: () => pen.lift(),
    });
    const observer = new ResizeObserver(() => arm.measure());
    observer.observe(element);
    shown.value = arm;
    return () => {
      observer.disconnect();
      cancelAnimationFrame(drawing);
      pointers.dispose();
      shown.value = null;
      arm.dispose();
      pointedJoint.value = null;
    };
  }, [aim, pen, shown, pictures]);

  useSignalEffect(() => {
    const { value: now } = picture;
    if (now) shown.value?.show(now);
  });

  const arm = shown.value;
  const { value: now } = picture;
  const search = session.search.value;
  const report = now ? targetText(words, now.target, search) : '';
  const penReport = penText(words, pen.place.value, pen.isDown.value);
  return (
    <div
      class="arm"
      data-outcome={search?.answer.outcome}
      data-strokes={pen.on.value ? strokesNow().length : undefined}
    >
      <div class="arm-view">
        <canvas ref={canvas} class="arm-canvas" aria-label={words.canvas} role="img" />
        {arm && now && (
          <>
            <ArmLabels arm={arm} joints={now.x.length / 3} pointed={now.pointedJoint} pictures={pictures} />
            <p class="arm-grid">
              {fillTemplate(words.grid, { step: formatQuantity(gridStepOf(reachOf(now)), 'm', 1) })}
            </p>
            <ArmHandle
              arm={arm}
              class="target-handle"
              at={now.target}
              label={report}
              keys={words.targetKeys}
              pictures={pictures}
              onKey={(event) => {
                const by = spaceMove(event, arm.camera);
                if (by) aim(now.target.map((value, axis) => value + by[axis]));
                return by !== null;
              }}
            />
            {pen.on.value && (
              <ArmHandle
                arm={arm}
                class="pen-handle"
                at={onFloor(pen.place.value)}
                label={penReport}
                keys={words.penKeys}
                pressed={pen.isDown.value}
                pictures={pictures}
                onKey={(event) => penKey(event, pen, arm)}
              />
            )}
          </>
        )}
      </div>
      <QuietLine text={pen.on.value ? penReport : report} />
      <ArmTools pen={pen} onFit={() => arm?.fit()} />
    </div>
  );
}

/** What is drawn now; null before the first search. */
function usePicture(session: KinematicsSession, pen: FloorPen): ReadonlySignal<ArmPicture | null> {
  const moment = useMoment(session);
  const stroke = useComputed(() => Float64Array.from(pen.stroke.value.flatMap((point) => onFloor(point))));
  return useComputed(() => {
    const { value: pose } = session.pose;
    if (!pose) return null;
    const { root, links, target } = state.value.kinematics;
    return {
      x: pose.x,
      root,
      links,
      target,
      moment: moment.value,
      curve: null,
      place: 0,
      stroke: stroke.value,
      pointedJoint: pointedJoint.value,
      palette: appliedTheme.value === 'dark' ? darkArmPalette : lightArmPalette,
    };
  });
}

/** Null at the end of a search, unless its events were gone through. */
function useMoment(session: KinematicsSession): ReadonlySignal<ArmMoment | null> {
  const steppedIn = useRef<Search | null>(null);
  return useComputed(() => {
    const { value: search } = session.search;
    const { value: event } = session.event;
    if (!search) return null;
    if (event < countEvents(search.answer)) steppedIn.current = search;
    return steppedIn.current === search ? momentOf(search, event) : null;
  });
}

/** Pointers and held keys may ask more often than there are pictures. */
function aimOncePerFrame(actions: Actions): (target: readonly number[]) => void {
  let wanted: readonly number[] | null = null;
  return (target) => {
    if (!wanted)
      requestAnimationFrame(() => {
        if (wanted) actions.setKinematics({ mode: 'aim', target: rounded(wanted) });
        wanted = null;
      });
    wanted = target;
  };
}

/** Returns whether the key meant something. */
function penKey(event: KeyboardEvent, pen: FloorPen, arm: Arm3D): boolean {
  const by = floorMove(event, arm.camera);
  const [x, y] = pen.place.value;
  if (by) pen.move([x + by[0], y + by[1]]);
  else if (event.key === ' ' && pen.isDown.value) pen.lift();
  else if (event.key === ' ') pen.draw([x, y]);
  else if (event.key === 'Enter') pen.putAway();
  else return false;
  return true;
}
