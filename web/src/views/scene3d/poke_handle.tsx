import { effect, type ReadonlySignal } from '@preact/signals';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import type { Pull } from '../../solver/protocol.ts';
import { directionOf, moveOf } from './arrow_keys.ts';
import type { Nets3D } from './nets3d.ts';
import { type Grip, pullBy } from './pull.ts';
import type { ScreenPoint } from './types.ts';
import './pin_handle.css';

interface Props {
  nets: Nets3D;
  /** #V×3, metres: at rest. */
  V: Float64Array;
  stiffness: number;
  pull: Pull | null;
  /** CSS pixels from the corner of what the handle is positioned in; null where nothing is drawn. */
  placeOf: (vertex: number) => ScreenPoint | null;
  /** Changes with every picture. */
  pictures: ReadonlySignal<number>;
  onPull: (pull: Pull | null) => void;
}

interface Held {
  grip: Grip;
  /** Metres. */
  by: readonly [number, number, number];
  /** What was made of both: when another pull has taken its place, nothing is held any more. */
  pull: Pull;
}

/** Poking for the keyboard: one focusable handle at a vertex. Arrows choose another vertex or, once it is grabbed, pull at it, as the reader sees it. */
export function PokeHandle({ nets, V, stiffness, pull, placeOf, pictures, onPull }: Props) {
  const [chosen, choose] = useState<number | null>(null);
  const [grabbed, setGrabbed] = useState<Held | null>(null);
  const handle = useRef<HTMLButtonElement>(null);
  const held = grabbed?.pull === pull ? grabbed : null;
  const vertex = chosen ?? nets.firstVertex();

  // Without rendering it anew with every picture.
  useLayoutEffect(
    () =>
      effect(() => {
        void pictures.value;
        const place = vertex === null ? null : placeOf(vertex);
        if (handle.current && place) handle.current.style.translate = `${place.x}px ${place.y}px`;
      }),
    [vertex, placeOf, pictures],
  );

  if (vertex === null) return null;
  const pullGripBy = (grip: Grip, by: Held['by']) => {
    const next = pullBy(grip, by, stiffness);
    setGrabbed({ grip, by, pull: next });
    onPull(next);
  };
  const toggle = () => {
    const grip = held ? null : nets.gripAt(vertex);
    if (grip) pullGripBy(grip, [0, 0, 0]);
    else onPull(null);
  };
  const goTowards = (direction: readonly [number, number]) => {
    const next = nets.vertexTowards(vertex, direction);
    if (next === null) return;
    choose(next);
    nets.mark(nets.gripAt(next)?.vertices ?? null);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const direction = directionOf(event.key);
    const by = moveOf(event, V, nets.camera);
    if (event.key === 'Enter' || event.key === ' ') toggle();
    else if (event.key === 'Escape' && held) onPull(null);
    else if (held && by) pullGripBy(held.grip, [held.by[0] + by[0], held.by[1] + by[1], held.by[2] + by[2]]);
    else if (direction) goTowards(direction);
    else return;
    event.preventDefault();
    event.stopPropagation(); // here keys move the handle, not time
  };

  return (
    <button
      ref={handle}
      type="button"
      class="pin-handle poke-handle"
      aria-pressed={held !== null}
      aria-label={t(held ? 'page.poke.held' : 'page.poke.choose', { vertex })}
      onFocus={() => nets.mark(nets.gripAt(vertex)?.vertices ?? null)}
      onBlur={() => nets.mark(null)}
      onClick={toggle}
      onKeyDown={onKeyDown}
    />
  );
}
