import { type ReadonlySignal, useComputed } from '@preact/signals';
import type { KinematicsSession } from '../../app/kinematics_session.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { state } from '../../app/state.ts';
import type { Aim } from './aim.ts';
import { en } from './arm_en.ts';
import { ArmHandle } from './arm_handle.tsx';
import { spaceMove } from './arm_keys.ts';
import type { ArmPicture } from './arm_picture.ts';
import { type Came, targetText } from './arm_words.ts';
import { zh } from './arm_zh.ts';
import type { Arm3D } from './arm3d.ts';

interface Props {
  arm: Arm3D;
  picture: ReadonlySignal<ArmPicture | null>;
  session: KinematicsSession;
  aim: Aim;
  /** Changes with every picture. */
  pictures: ReadonlySignal<number>;
}

/** The target for the keyboard, and in words. */
export function TargetHandle({ arm, picture, session, aim, pictures }: Props) {
  const words = inLanguage({ en, zh });
  const target = useComputed(() => picture.value?.target ?? state.value.kinematics.target).value;
  const text = targetText(words, target, cameOf(session));
  const onKey = (event: KeyboardEvent) => {
    const step = spaceMove(event, arm.camera);
    if (step) aim.by(step, target);
    return step !== null;
  };
  return (
    <ArmHandle
      arm={arm}
      class="target-handle"
      at={target}
      label={text}
      keys={words.targetKeys}
      pictures={pictures}
      onKey={onKey}
    />
  );
}

/** What became of the search for the target; null before the first. */
function cameOf({ drawing, place, playing, search }: KinematicsSession): Came | null {
  if (!playing.value || !drawing.value) return search.value?.answer ?? null;
  const { outcomes, errors } = drawing.value.followed;
  return { outcome: outcomes[place.value], error: errors[place.value] };
}
