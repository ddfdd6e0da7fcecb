import { t } from '../../app/messages/index.ts';
import { frame, parameters, scene } from '../../app/state.ts';
import type { Frame } from '../../solver/frame.ts';
import './solver_panel.css';

/** How much work there is and what was done again: above all, when Q was factorised and why. */
export function SolverPanel() {
  const { factorisations, stiffnessNumber, milliseconds } = frame.value as Frame;
  const { m, E } = scene.value;
  return (
    <section class="solver-panel" aria-labelledby="solver-heading">
      <h2 id="solver-heading">{t('page.solver.heading')}</h2>
      <dl>
        <dt>{t('page.solver.factorisations')}</dt>
        <dd data-testid="factorisations">
          {t('page.solver.times', { count: factorisations.count })} ·{' '}
          {t('page.solver.because', {
            reason: t(`page.solver.reason.${factorisations.reason}`),
          })}
        </dd>
        <dt>{t('page.solver.pins')}</dt>
        <dd data-testid="pins-held">{t(`page.solver.held.${parameters.value.path}`)}</dd>
        <dt>{t('page.solver.stiffness')}</dt>
        <dd>{stiffnessNumber.toPrecision(3)}</dd>
        <dt>{t('page.solver.milliseconds')}</dt>
        <dd>{milliseconds.toFixed(1)} ms</dd>
        <dt class="visually-hidden">{t('page.controls.scene')}</dt>
        <dd class="size">{t('page.solver.size', { vertices: m.length, springs: E.length / 2 })}</dd>
      </dl>
    </section>
  );
}
