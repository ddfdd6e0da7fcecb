import { effect, type ReadonlySignal, useComputed } from '@preact/signals';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { reachOf } from '../../app/kinematics.ts';
import { pointedJoint } from '../../app/pointed_joint.ts';
import { state } from '../../app/state.ts';
import { floorRadius } from './arm_floor.ts';
import type { Arm3D } from './arm3d.ts';

interface Props {
  arm: Arm3D;
  /** Changes with every picture. */
  pictures: ReadonlySignal<number>;
}

/** CSS pixels: labels nearer to one another would cover each other. */
const crowded = 15;
/** Of the floor, where its axes are named. */
const axisEnd = 0.36;

/** The joints' numbers beside them, and the names of the floor's axes. */
export function ArmLabels({ arm, pictures }: Props) {
  const joints = useComputed(() => state.value.kinematics.links.length + 1).value;
  const { value: pointed } = pointedJoint;
  const list = useRef<HTMLDivElement>(null);

  // Without rendering it anew with every picture.
  useLayoutEffect(
    () =>
      effect(() => {
        void pictures.value;
        if (list.current) placeLabels(list.current, arm);
      }),
    [arm, pictures, joints],
  );

  return (
    <div ref={list} class="arm-labels" aria-hidden="true">
      {Array.from({ length: joints }, (_, joint) => (
        <span key={joint} class={joint === pointed ? 'arm-joint pointed' : 'arm-joint'}>
          {joint}
        </span>
      ))}
      <span key="x" class="arm-axis">
        x
      </span>
      <span key="z" class="arm-axis">
        z
      </span>
    </div>
  );
}

function placeLabels(list: HTMLElement, arm: Arm3D): void {
  const picture = arm.eye()?.picture;
  if (!picture || picture.x.length + 6 !== 3 * list.children.length) return; // the arm of before, until the new one is found
  const along = axisEnd * floorRadius(reachOf(picture));
  const { x: joints, root } = picture;
  const places = arm.placesOf(Float64Array.of(...joints, root[0] + along, 0, 0, 0, 0, root[2] + along));
  if (!places) return;
  const taken: [number, number][] = [];
  [...list.children].forEach((label, at) => {
    const [left, top] = places.subarray(2 * at, 2 * at + 2);
    const shown = !Number.isNaN(left) && taken.every(([x, y]) => Math.hypot(left - x, top - y) > crowded);
    (label as HTMLElement).hidden = !shown;
    if (!shown) return;
    taken.push([left, top]);
    (label as HTMLElement).style.translate = `${left}px ${top}px`;
  });
}
