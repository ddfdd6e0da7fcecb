import { effect } from '@preact/signals';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { t } from '../../app/messages/index.ts';
import { pins, scene } from '../../app/state.ts';
import { diagonal, screenAxes } from './geometry.ts';
import { canvasOrigin, pictures, scene3D } from './stage_signals.ts';

/** One press of an arrow key, as a fraction of the scene's diagonal; ten times as much with Shift. */
const stride = 0.005;

const directions: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** The pins for the keyboard: one focusable handle that stands where the chosen pin is drawn; arrows move it as the reader sees it. */
export function PinHandle({ actions }: { actions: Actions }) {
  const [chosen, choose] = useState(0);
  const { pinned, targets } = pins.value;
  const row = Math.min(chosen, pinned.length - 1);
  const vertex = pinned[row];
  const handle = useHandleOn(vertex);
  const view = scene3D.value;
  if (pinned.length === 0) return <p class="no-pins">{t('page.pinHandle.none')}</p>;
  if (!view) return null;
  const target = [...targets.subarray(3 * row, 3 * row + 3)];
  const [x, y, z] = target.map((value) => value.toFixed(3));

  const onKeyDown = (event: KeyboardEvent) => {
    const direction = directions[event.key];
    const turn = event.key === 'PageDown' ? 1 : event.key === 'PageUp' ? -1 : 0;
    if (turn !== 0) choose((row + turn + pinned.length) % pinned.length);
    else if (direction) {
      const by = stride * diagonal(scene.value.V) * (event.shiftKey ? 10 : 1);
      const { right, up } = screenAxes(view.camera);
      const moved = target.map((value, axis) => value + by * (direction[0] * right[axis] + direction[1] * up[axis]));
      actions.movePin(vertex, moved as [number, number, number]);
    } else return;
    event.preventDefault();
    event.stopPropagation(); // here arrows move the pin, not the cursor in time
  };

  return (
    <button
      ref={handle}
      type="button"
      class="pin-handle"
      aria-label={t('page.pinHandle.label', { row: row + 1, count: pinned.length, vertex, x, y, z })}
      onFocus={() => actions.selectVertex(vertex)}
      onKeyDown={onKeyDown}
    />
  );
}

/** Keeps the element that the returned ref is given to where each picture shows a vertex, without rendering it anew. */
function useHandleOn(vertex: number) {
  const handle = useRef<HTMLButtonElement>(null);
  useLayoutEffect(
    () =>
      effect(() => {
        void pictures.value;
        const place = scene3D.value?.projectToScreen(vertex, 'global');
        const { x, y } = canvasOrigin.value;
        if (handle.current && place) handle.current.style.translate = `${x + place.x}px ${y + place.y}px`;
      }),
    [vertex],
  );
  return handle;
}
