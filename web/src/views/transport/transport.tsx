import { useState } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { t } from '../../app/messages/index.ts';
import { frame, parameters, playing } from '../../app/state.ts';
import { Icon } from '../../lib/icon.tsx';
import type { Frame, Phase } from '../../solver/frame.ts';
import { placeOf } from '../../solver/read_frame.ts';
import { statusText } from './status_text.ts';
import { Timeline } from './timeline.tsx';
import './transport.css';

interface Props {
  actions: Actions;
  /** False where the page has the lines of time at large. */
  timeline?: boolean;
}

/** The clock's buttons, the lines of time, and the line that always says where we are. */
export function Transport({ actions, timeline = true }: Props) {
  const [hasPaused, setHasPaused] = useState(false);
  const f = frame.value as Frame;
  const invite = playing.value && !hasPaused;
  const toggle = () => {
    setHasPaused(true);
    if (invite) actions.lookInside();
    else actions.togglePlaying();
  };
  const next = placeOf(f.half_step === f.last_half_step ? 0 : f.half_step + 1, f.last_half_step).phase;
  return (
    <section class="transport" id="transport" tabIndex={-1} aria-label={t('page.transport.label')}>
      <div class="transport-buttons">
        <Move to="reset" actions={actions} />
        <Move to="previousStep" off={f.rememberedSteps === 0} actions={actions} />
        <Move to="previousHalfStep" half off={f.half_step === 0 && f.rememberedSteps === 0} actions={actions} />
        <button type="button" class={`play ${invite ? 'play-invite' : ''}`} onClick={toggle}>
          <Icon name={playing.value ? 'pause' : 'play'} />
          {t(invite ? 'page.transport.inviteToPause' : playing.value ? 'page.transport.pause' : 'page.transport.play')}
        </button>
        <Move to="nextHalfStep" half leadsTo={next} actions={actions} />
        <Move to="nextStep" actions={actions} />
      </div>
      <div class="transport-place">
        <p class="transport-status" data-testid="status" aria-live={playing.value ? 'off' : 'polite'}>
          {statusText(f)}
        </p>
        <p class="transport-story">{storyText(f)}</p>
      </div>
      {timeline && <Timeline frame={f} actions={actions} />}
    </section>
  );
}

/** What the half-step does. */
function storyText({ phase, iterations }: Frame): string {
  const { method } = parameters.value;
  if (playing.value) return t('page.story.playing', { iterations });
  if (phase === 'global' && method !== 'local-global')
    return t('page.story.accelerated', { method: t(`methods.name.${method}`) });
  return t(`page.story.${phase}`, { iterations });
}

interface MoveProps {
  to: 'reset' | 'previousStep' | 'previousHalfStep' | 'nextHalfStep' | 'nextStep';
  actions: Actions;
  half?: boolean;
  off?: boolean;
  /** Said in words beside the icon. */
  leadsTo?: Phase;
}

function Move({ to, actions, half = false, off = false, leadsTo }: MoveProps) {
  const words = leadsTo && t(`page.phase.${leadsTo}`);
  const label = words ? `${t(`page.transport.${to}`)}: ${words}` : t(`page.transport.${to}`);
  return (
    <button
      type="button"
      class="move"
      aria-label={label}
      title={label}
      aria-disabled={off}
      onClick={off ? undefined : () => actions[to]()}
    >
      <Icon name={to} />
      {half && <span class="half-sign" />}
      {words && <span class={`next-phase ${leadsTo}`}>{words}</span>}
    </button>
  );
}
