import { t } from '../../app/messages/index.ts';
import { playing } from '../../app/state.ts';
import type { Frame } from '../../solver/frame.ts';

/** Where the clock and the cursor stand, in one line. */
export function statusText({ step, iteration, iterations, phase }: Frame): string {
  if (playing.value) return t('page.transport.playing', { step, iterations });
  return t('page.transport.status', { step, iteration, iterations, phase: t(`page.phase.${phase}`) });
}
