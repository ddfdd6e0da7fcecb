import type { Drawing } from '../../../app/kinematics_drawing.ts';
import type { KinematicsSession } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { Icon } from '../../../lib/icon.tsx';
import { RangeInput } from '../../../lib/range_input.tsx';
import { StepButton } from '../../../views/stepper/step_button.tsx';
import '../../../views/stepper/stepper.css';
import { en } from './en.ts';
import { zh } from './zh.ts';
import './motion.css';

interface Props {
  session: KinematicsSession;
  drawing: Drawing;
}

/** From target to target of the drawing. */
export function DrawingTransport({ session, drawing }: Props) {
  const words = inLanguage({ en, zh });
  const { value: place } = session.place;
  const { value: playing } = session.playing;
  const last = drawing.strokes.length - 1;
  const goTo = (to: number) => void session.goTo(to);
  return (
    <fieldset class="stepper drawing-transport" aria-label={words.label}>
      <button type="button" class="play" onClick={() => (playing ? void session.pause() : session.play())}>
        <Icon name={playing ? 'pause' : 'play'} />
        {playing ? words.pause : words.play}
      </button>
      <StepButton icon="reset" label={words.reset} off={place === 0} onClick={() => goTo(0)} />
      <StepButton icon="previousStep" label={words.back} off={place === 0} onClick={() => goTo(place - 1)} />
      <StepButton icon="nextStep" label={words.forward} off={place === last} onClick={() => goTo(place + 1)} />
      <RangeInput min={0} max={last} value={place} aria-label={words.target} onValue={goTo} />
      <p class="drawing-place" aria-live={playing ? 'off' : 'polite'}>
        {fillTemplate(words.place, { place: place + 1, count: last + 1 })}
        {drawing.strokes[place] < 0 && `, ${words.air}`}
      </p>
    </fieldset>
  );
}
