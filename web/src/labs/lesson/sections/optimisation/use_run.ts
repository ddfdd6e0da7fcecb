import { useEffect } from 'preact/hooks';
import type { FigureSession } from '../../figures/figure_session.ts';

/**
 * While `running`, steps two figures in real time: the first by the forces at p^t, the second as always. Every picture of the first one, also that
 * of a changed parameter, sets the time of the next step.
 */
export function useRun(running: boolean, explicit: FigureSession, implicit: FigureSession): void {
  useEffect(() => {
    if (!running) return;
    let timer = 0;
    const settled = () => (explicit.moving ? null : explicit.checkpoint());
    const step = async () => {
      const here = settled();
      const seen = here && (await explicit.inspect());
      if (!seen || here !== settled()) return; // moving, or moved meanwhile: its new picture sets the timer
      const to = { step: here.step + 1, half_step: 0, p_curr: seen.explicitStep, p_prev: here.p_curr };
      explicit.order({ kind: 'jump', to });
      implicit.order({ kind: 'next_step' });
    };
    const stop = explicit.frame.subscribe(() => {
      clearTimeout(timer);
      timer = setTimeout(() => void step(), 1000 * explicit.parameters.value.delta_t);
    });
    return () => {
      stop();
      clearTimeout(timer);
    };
  }, [running, explicit, implicit]);
}
