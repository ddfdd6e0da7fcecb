import { useContext } from 'preact/hooks';
import { t } from '../../../app/messages/index.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { StepButton } from '../../../views/stepper/step_button.tsx';
import { LessonActions } from '../lesson_actions.ts';
import { lessonWords } from '../lesson_words.ts';
import type { FigureSession } from './figure_session.ts';

/** The clock's buttons, where it stands, and the way to the lab. */
export function FigureTransport({ figure }: { figure: FigureSession }) {
  const playing = figure.playing.value;
  const frame = figure.frame.value;
  const actions = useContext(LessonActions);
  const openInLab = () => {
    const moment = figure.forLab();
    if (moment) void actions?.openMoment(moment.state, moment.from);
  };
  const atBeginning = !frame || (frame.half_step === 0 && frame.rememberedSteps === 0);
  return (
    <fieldset class="figure-transport" aria-label={t('page.transport.label')}>
      <StepButton icon="reset" label={t('page.transport.reset')} onClick={() => figure.reset()} />
      <StepButton
        icon="previousHalfStep"
        half
        label={t('page.transport.previousHalfStep')}
        off={atBeginning}
        onClick={() => figure.order({ kind: 'previous_half_step' })}
      />
      <StepButton
        icon={playing ? 'pause' : 'play'}
        label={t(playing ? 'page.transport.pause' : 'page.transport.play')}
        onClick={() => {
          figure.playing.value = !playing;
        }}
      />
      <StepButton
        icon="nextHalfStep"
        half
        label={t('page.transport.nextHalfStep')}
        onClick={() => figure.order({ kind: 'next_half_step' })}
      />
      <StepButton
        icon="nextStep"
        label={t('page.transport.nextStep')}
        onClick={() => figure.order({ kind: 'next_step' })}
      />
      <Place figure={figure} />
      <button type="button" class="figure-to-lab" onClick={openInLab}>
        {lessonWords().figure.openInLab}
      </button>
    </fieldset>
  );
}

/** In words, where the clock and the cursor stand. */
function Place({ figure }: { figure: FigureSession }) {
  const words = lessonWords().figure;
  const playing = figure.playing.value;
  const frame = figure.frame.value;
  if (!frame) return <p class="figure-place">{words.loading}</p>;
  const { step, iteration, iterations, phase } = frame;
  const place = { step, iteration, iterations, phase: t(`page.phase.${phase}`) };
  return (
    <p class="figure-place" data-phase={phase} aria-live={playing ? 'off' : 'polite'}>
      {fillTemplate(playing ? words.playing : words.place, place)}
    </p>
  );
}
