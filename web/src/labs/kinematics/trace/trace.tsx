import type { KinematicsSession, Search } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { countEvents } from '../../../app/pose.ts';
import { RangeInput } from '../../../lib/range_input.tsx';
import { StepButton } from '../../../views/stepper/step_button.tsx';
import { en } from './en.ts';
import { iterationEnds, momentAt } from './moment.ts';
import { momentText } from './moment_text.ts';
import { zh } from './zh.ts';
import '../../../views/stepper/stepper.css';
import './trace.css';

/** Forwards and backwards through one search: by what happened, by iterations, or to anywhere. */
export function Trace({ session }: { session: KinematicsSession }) {
  const words = inLanguage({ en, zh });
  const search = session.search.value as Search; // the lab is shown once there is one
  const { value: event } = session.event;
  const last = countEvents(search.answer);
  const ends = iterationEnds(search);
  const atStart = event === 0;
  const atEnd = event === last;
  const to = (place: number | undefined) => session.seek(place ?? event);
  const text = momentText(search, momentAt(search, event));
  return (
    <section class="trace" aria-label={words.label}>
      <div class="stepper">
        <StepButton icon="first" label={words.first} off={atStart} onClick={() => to(0)} />
        <StepButton
          icon="previousStep"
          label={words.iterationBack}
          off={atStart}
          onClick={() => to(ends.findLast((end) => end < event))}
        />
        <StepButton icon="previousHalfStep" label={words.back} off={atStart} onClick={() => to(event - 1)} />
        <StepButton icon="nextHalfStep" label={words.forward} off={atEnd} onClick={() => to(event + 1)} />
        <StepButton
          icon="nextStep"
          label={words.iterationForward}
          off={atEnd}
          onClick={() => to(ends.find((end) => end > event))}
        />
        <StepButton icon="last" label={words.last} off={atEnd} onClick={() => to(last)} />
      </div>
      <RangeInput
        min={0}
        max={last}
        value={event}
        disabled={last === 0}
        aria-label={words.slider}
        aria-valuetext={text}
        onValue={(value) => session.seek(value)}
      />
      <output class="trace-place" aria-live={session.playing.value ? 'off' : 'polite'} data-testid="moment">
        {text}
      </output>
      <button type="button" title={words.hangHint} onClick={() => void session.hang()}>
        {words.hang}
      </button>
    </section>
  );
}
