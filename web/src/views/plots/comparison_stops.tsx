import { t } from '../../app/messages/index.ts';
import { parameters } from '../../app/state.ts';
import { formatNumber } from '../../lib/format.ts';
import { type Minimiser, minimisers } from '../../solver/module.ts';
import type { Stop } from '../../solver/stop_of.ts';
import type { Curve } from './comparison_curves.ts';
import { gapText, heightUnit, Swatch } from './comparison_readout.tsx';

interface Props {
  curves: readonly Curve[];
  /** Null beyond what was computed. */
  stops: ReadonlyMap<Minimiser, Stop | null>;
}

/** Where each method ends the time step under the rule in force: the dots of the plot in numbers. */
export function ComparisonStops({ curves, stops }: Props) {
  return (
    <table class="comparison-numbers comparison-stops">
      <caption>{t('plots.comparison.ends', { rule: ruleText() })}</caption>
      <thead>
        <tr>
          <th scope="col">{t('methods.label')}</th>
          <th scope="col">{t('plots.comparison.iterations')}</th>
          <th scope="col">{heightUnit('gap')}</th>
          <th scope="col">{t('plots.comparison.milliseconds')}</th>
          <th scope="col">{t('plots.comparison.endedBy')}</th>
        </tr>
      </thead>
      <tbody>
        {inOrder(curves).map((curve) => (
          <tr key={curve.method} data-method={curve.method}>
            <th scope="row">
              <Swatch method={curve.method} />
              {t(`methods.name.${curve.method}`)}
            </th>
            <Numbers curve={curve} stop={stops.get(curve.method) ?? null} />
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Numbers({ curve: { points, milliseconds }, stop }: { curve: Curve; stop: Stop | null }) {
  if (!stop) return <td colSpan={4}>{t('plots.comparison.notReached', { iterations: points.length - 1 })}</td>;
  const { iterations, reason } = stop;
  const { gap } = points[Math.min(iterations, points.length - 1)]; // once E falls no further, nothing changes
  return (
    <>
      <td>{iterations}</td>
      <td>{gapText(gap)}</td>
      <td>{formatNumber(iterations * milliseconds, 2)}</td>
      <td>{t(`plots.comparison.stop.${reason}`)}</td>
    </>
  );
}

/** As in the legend. */
function inOrder(curves: readonly Curve[]): Curve[] {
  return minimisers.flatMap((method) => curves.find((curve) => curve.method === method) ?? []);
}

/** When a time step ends, with the numbers in force. */
export function ruleText(): string {
  const { iterations, stop_gradient, stop_decrease } = parameters.value;
  if (stop_gradient > 0)
    return t('plots.comparison.rule.stop_gradient', { iterations, epsilon: formatNumber(stop_gradient, 2) });
  if (stop_decrease > 0)
    return t('plots.comparison.rule.stop_decrease', { iterations, epsilon: formatNumber(stop_decrease, 2) });
  return t('plots.comparison.rule.never', { iterations });
}
