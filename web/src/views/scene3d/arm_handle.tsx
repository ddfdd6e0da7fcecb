import { effect, type ReadonlySignal } from '@preact/signals';
import { useId, useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { Point3 } from '../../app/kinematics.ts';
import type { Arm3D } from './arm3d.ts';
import { QuietLine } from './quiet_line.tsx';
import './pin_handle.css';

interface Props {
  arm: Arm3D;
  class: string;
  /** m: where it stands. */
  at: Point3;
  label: string;
  /** What its keys do. */
  keys: string;
  pressed?: boolean;
  /** Changes with every picture. */
  pictures: ReadonlySignal<number>;
  /** From the beginning. */
  focused?: boolean;
  /** Whether the key meant something. */
  onKey: (event: KeyboardEvent) => boolean;
}

/** Something in the picture for the keyboard: focusable, and standing where it is drawn or at the picture's nearest edge. */
export function ArmHandle({ arm, class: name, at, label, keys, pressed, pictures, focused = false, onKey }: Props) {
  const handle = useRef<HTMLButtonElement>(null);
  const description = useId();
  const [hasFocus, setFocus] = useState(false);

  // Without rendering it anew with every picture.
  useLayoutEffect(
    () =>
      effect(() => {
        void pictures.value;
        const place = arm.placeOnCanvas(at);
        if (handle.current && place) handle.current.style.translate = `${place.x}px ${place.y}px`;
      }),
    [arm, at, pictures],
  );
  useLayoutEffect(() => {
    if (focused) handle.current?.focus({ preventScroll: true });
  }, [focused]);

  return (
    <>
      <button
        ref={handle}
        type="button"
        class={`pin-handle ${name}`}
        aria-label={label}
        aria-describedby={description}
        aria-pressed={pressed}
        onFocus={() => setFocus(true)}
        onBlur={() => setFocus(false)}
        onKeyDown={(event) => {
          if (!onKey(event)) return;
          event.preventDefault();
          event.stopPropagation(); // here keys move the handle, not time
        }}
      />
      <span id={description} hidden>
        {keys}
      </span>
      {hasFocus && <QuietLine text={label} />}
    </>
  );
}
