import { useComputed, useSignal, useSignalEffect } from '@preact/signals';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { reachOf } from '../../app/kinematics.ts';
import type { KinematicsSession } from '../../app/kinematics_session.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { notify } from '../../app/notices.ts';
import { pointedJoint } from '../../app/pointed_joint.ts';
import { state } from '../../app/state.ts';
import { fillTemplate } from '../../lib/fill_template.ts';
import { formatQuantity } from '../../lib/format.ts';
import { Aim } from './aim.ts';
import { en } from './arm_en.ts';
import { gridStepOf } from './arm_floor.ts';
import { offFloor } from './arm_geometry.ts';
import { ArmLabels } from './arm_labels.tsx';
import { ArmPointers } from './arm_pointers.ts';
import { ArmTools } from './arm_tools.tsx';
import { zh } from './arm_zh.ts';
import { Arm3D } from './arm3d.ts';
import { type FloorPen, strokesNow } from './floor_pen.ts';
import { PenHandle } from './pen_handle.tsx';
import { TargetHandle } from './target_handle.tsx';
import { useArmPicture } from './use_arm_picture.ts';
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
  const toggle = useRef<HTMLButtonElement>(null);
  const shown = useSignal<Arm3D | null>(null);
  const pictures = useSignal(0);
  const aim = useMemo(() => new Aim(actions), [actions]);
  const picture = useArmPicture(session, pen);

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
      onTarget: (target) => aim.to(target),
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
    if (pen.on.value) canvas.current?.scrollIntoView({ block: 'nearest' }); // it may be taken from further down the page
  });
  useSignalEffect(() => {
    const { value: now } = picture;
    if (now) shown.value?.show(now);
  });

  const arm = shown.value;
  const ready = useComputed(() => picture.value !== null).value;
  const gridStep = gridStepOf(reachOf(state.value.kinematics));
  return (
    <div class="arm" data-strokes={strokesNow().length}>
      <div class="arm-view">
        <canvas ref={canvas} class="arm-canvas" aria-label={words.canvas} role="img" />
        <p class="arm-grid">{fillTemplate(words.grid, { step: formatQuantity(gridStep, 'm', 1) })}</p>
        {arm && ready && (
          <>
            <ArmLabels arm={arm} pictures={pictures} />
            <TargetHandle arm={arm} picture={picture} session={session} aim={aim} pictures={pictures} />
            {pen.on.value && (
              <PenHandle arm={arm} pen={pen} pictures={pictures} onEnd={() => toggle.current?.focus()} />
            )}
          </>
        )}
      </div>
      <ArmTools pen={pen} toggle={toggle} onFit={() => arm?.fit()} />
    </div>
  );
}
