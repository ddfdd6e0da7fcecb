import { effect, type ReadonlySignal } from '@preact/signals';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { cardId } from '../../app/pointing.ts';
import type { Camera } from '../../app/state.ts';
import type { Pins } from '../../solver/protocol.ts';
import { moveOf } from './arrow_keys.ts';
import type { ScreenPoint } from './types.ts';
import './pin_handle.css';

interface Props {
  pins: Pins;
  /** #V×3, metres: at rest. */
  V: Float64Array;
  camera: () => Camera;
  /** CSS pixels from the corner of what the handle is positioned in; null where nothing is drawn. */
  placeOf: (vertex: number) => ScreenPoint | null;
  /** Changes with every picture. */
  pictures: ReadonlySignal<number>;
  onMove: (vertex: number, target: [number, number, number]) => void;
  onFocus?: (vertex: number) => void;
}

/** The pins for the keyboard: one focusable handle that stands where the chosen pin is drawn; arrows move it as the reader sees it. */
export function PinHandle({ pins: { pinned, targets }, V, camera, placeOf, pictures, onMove, onFocus }: Props) {
  const [chosen, choose] = useState(0);
  const row = Math.min(chosen, pinned.length - 1);
  const vertex = pinned[row];
  const handle = useRef<HTMLButtonElement>(null);

  // Without rendering it anew with every picture.
  useLayoutEffect(
    () =>
      effect(() => {
        void pictures.value;
        const place = placeOf(vertex);
        if (handle.current && place) handle.current.style.translate = `${place.x}px ${place.y}px`;
      }),
    [vertex, placeOf, pictures],
  );

  if (pinned.length === 0) return <p class="no-pins">{t('page.pinHandle.none')}</p>;
  const target = [...targets.subarray(3 * row, 3 * row + 3)];
  const [x, y, z] = target.map((value) => value.toFixed(3));

  const onKeyDown = (event: KeyboardEvent) => {
    const by = moveOf(event, V, camera());
    const turn = event.key === 'PageDown' ? 1 : event.key === 'PageUp' ? -1 : 0;
    if (turn !== 0) choose((row + turn + pinned.length) % pinned.length);
    else if (by) onMove(vertex, target.map((value, axis) => value + by[axis]) as [number, number, number]);
    else return;
    event.preventDefault();
    event.stopPropagation(); // here arrows move the pin, not the cursor in time
  };

  return (
    <button
      ref={handle}
      type="button"
      class="pin-handle"
      data-vertex={vertex}
      aria-describedby={cardId}
      aria-label={t('page.pinHandle.label', { row: row + 1, count: pinned.length, vertex, x, y, z })}
      onFocus={() => onFocus?.(vertex)}
      onKeyDown={onKeyDown}
    />
  );
}
