import type { ReadonlySignal } from '@preact/signals';
import { onFloor } from '../../app/kinematics_drawing.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { en } from './arm_en.ts';
import { ArmHandle } from './arm_handle.tsx';
import { floorMove } from './arm_keys.ts';
import { penText } from './arm_words.ts';
import { zh } from './arm_zh.ts';
import type { Arm3D } from './arm3d.ts';
import type { FloorPen } from './floor_pen.ts';

interface Props {
  arm: Arm3D;
  pen: FloorPen;
  /** Changes with every picture. */
  pictures: ReadonlySignal<number>;
  /** Its keys have put the pen away. */
  onEnd: () => void;
}

/** The pen for the keyboard, and in words. */
export function PenHandle({ arm, pen, pictures, onEnd }: Props) {
  const words = inLanguage({ en, zh });
  const text = penText(words, pen.place.value, pen.isDown.value);
  const onKey = ({ key, shiftKey }: KeyboardEvent) => {
    const step = floorMove({ key, shiftKey }, arm.camera);
    const [x, y] = pen.place.peek();
    if (step) pen.move([x + step[0], y + step[1]]);
    else if (key === ' ' && pen.isDown.peek()) pen.lift();
    else if (key === ' ') pen.draw([x, y]);
    else if (key === 'Enter') {
      pen.putAway();
      onEnd();
    } else return false;
    return true;
  };
  return (
    <ArmHandle
      arm={arm}
      class="pen-handle"
      at={onFloor(pen.place.value)}
      label={text}
      keys={words.penKeys}
      pressed={pen.isDown.value}
      pictures={pictures}
      focused={pen.byKeys}
      onKey={onKey}
    />
  );
}
