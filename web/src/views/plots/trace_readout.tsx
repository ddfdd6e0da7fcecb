import type { ComponentChildren } from 'preact';
import { t } from '../../app/messages/index.ts';
import { formatLength, formatQuantity } from '../../lib/format.ts';
import type { TraceEvent } from '../../solver/frame.ts';
import type { TracePoint } from './objective_trace.ts';

/** Significant digits that tell apart what neighbouring half-steps change. */
const exact = 6;

export function placeText({ half_step: halfStep, iteration, phase }: TraceEvent): string {
  return t('plots.place', { halfStep, iteration, phase: t(`page.phase.${phase}`) });
}

/** One half-step in numbers: what it did, the objective and its terms. */
export function TraceReadout({ point: { event, drop } }: { point: TracePoint }) {
  return (
    <div class="trace-readout">
      <p>
        <strong>{placeText(event)}</strong>
      </p>
      <dl>
        {drop !== null && <Quantity name={t('plots.drop')}>{formatQuantity(drop, 'J')}</Quantity>}
        <Quantity name={t('plots.gradient')}>{formatQuantity(event.gradient, 'N', 2)}</Quantity>
        {!Number.isNaN(event.residual) && (
          <Quantity name={t('plots.residual')}>{formatQuantity(event.residual, 'N', 2)}</Quantity>
        )}
        {event.phase === 'global' && <Quantity name={t('plots.change')}>{formatLength(event.change)}</Quantity>}
        <Quantity name={t('plots.objective')}>{formatQuantity(event.objective, 'J', exact)}</Quantity>
        {(['potential', 'inertia', 'external', 'pin'] as const).map((term) => (
          <Quantity key={term} name={t(`plots.${term}`)}>
            {formatQuantity(event[term], 'J', exact)}
          </Quantity>
        ))}
      </dl>
    </div>
  );
}

function Quantity({ name, children }: { name: string; children: ComponentChildren }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{children}</dd>
    </div>
  );
}
