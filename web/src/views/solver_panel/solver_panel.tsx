import { drawingTime, iterationTime, playedStep } from '../../app/measurements.ts';
import { t } from '../../app/messages/index.ts';
import { frame, parameters, playing, scene } from '../../app/state.ts';
import type { Frame } from '../../solver/frame.ts';
import { type Part, PartList, TimeBudget } from './time_budget.tsx';
import './solver_panel.css';

/** ms between two pictures of a 60 Hz screen. */
const refresh_ms = 1000 / 60;

/** How much work there is, what it costs and what was done again: above all, when Q was factorised and why. */
export function SolverPanel() {
  const { factorisations, stiffnessNumber } = frame.value as Frame;
  const { m, E } = scene.value;
  return (
    <section class="solver-panel" aria-labelledby="solver-heading">
      <h2 id="solver-heading">{t('page.solver.heading')}</h2>
      {playing.value ? <StepBudget /> : <IterationTime />}
      {drawingTime.value !== null && (
        <TimeBudget
          name={t('page.solver.drawing')}
          parts={[{ name: t('page.solver.drawing'), ms: drawingTime.value, colour: '--accent' }]}
          budget_ms={refresh_ms}
          budgetName={t('page.solver.refresh')}
        />
      )}
      <dl>
        <dt>{t('page.solver.iterations')}</dt>
        <dd data-testid="iterations">{iterationsText(frame.value as Frame)}</dd>
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
        <dt class="visually-hidden">{t('page.controls.scene')}</dt>
        <dd class="size">{t('page.solver.size', { vertices: m.length, springs: E.length / 2 })}</dd>
      </dl>
    </section>
  );
}

/** What a time step takes of the time that it simulates: beyond it the clock runs slower than real time. */
function StepBudget() {
  const parts = stepParts();
  if (!parts) return null;
  return (
    <TimeBudget
      name={t('page.solver.timeStep')}
      parts={parts}
      budget_ms={1000 * parameters.value.delta_t}
      budgetName="Δt"
    />
  );
}

/** The halves of every iteration and what is left of a whole time step. Null before anything was measured. */
function stepParts(): Part[] | null {
  const iteration = iterationTime.value;
  const whole = playedStep.value;
  if (!iteration || whole === null) return null;
  const inverse = parameters.value.method !== 'newton'; // which solves with another matrix, as part of the rest
  const { iterations } = frame.value as Frame;
  const local = iterations * iteration.local;
  const global = inverse ? iterations * iteration.global : 0;
  const parts = [{ name: t('page.solver.localPart', { iterations }), ms: local, colour: '--symbol-d' }];
  if (inverse) parts.push({ name: t('page.solver.globalPart', { iterations }), ms: global, colour: '--symbol-p' });
  parts.push({ name: t('page.solver.rest'), ms: Math.max(0, whole - local - global), colour: '--muted' });
  return parts;
}

/** While paused no whole time step is measured, and only an iteration of local/global is nothing but its two halves. */
function IterationTime() {
  const iteration = iterationTime.value;
  if (parameters.value.method !== 'local-global')
    return (
      <div class="budget">
        <p class="budget-name">
          <span>{t('page.solver.timeStep')}</span> <span>{t('page.solver.timeElsewhere')}</span>
        </p>
      </div>
    );
  if (!iteration) return null;
  return (
    <div class="budget">
      <p class="budget-name">
        <span>{t('page.solver.iteration')}</span>
      </p>
      <PartList
        parts={[
          { name: t('page.solver.local'), ms: iteration.local, colour: '--symbol-d' },
          { name: t('page.solver.global'), ms: iteration.global, colour: '--symbol-p' },
        ]}
      />
    </div>
  );
}

/** How many iterations this time step took, and what ended it. */
function iterationsText({ iterations, stopReason }: Frame): string {
  const most = parameters.value.iterations;
  if (stopReason === '') return t('page.solver.stop.unknown', { most });
  return t(`page.solver.stop.${stopReason}`, { iterations, most });
}
