import type { ComponentChildren } from 'preact';
import { type Comparison, newtonWanted } from '../../app/comparison.ts';
import { t } from '../../app/messages/index.ts';
import { refusalParams } from '../../app/refusal_params.ts';
import { formatNumber } from '../../lib/format.ts';
import { type Minimiser, minimisers } from '../../solver/module.ts';
import { type Abscissa, type Curve, type CurvePoint, type Ordinate, pointAt } from './comparison_curves.ts';
import { methodStyles } from './method_styles.ts';

interface Props {
  /** Where the numbers are read off. */
  caption: string;
  made: Comparison;
  curves: readonly Curve[];
  hidden: readonly Minimiser[];
  abscissa: Abscissa;
  place: number;
  /** The time step has passed: nothing is added any more. */
  stale: boolean;
  onToggle: (method: Minimiser) => void;
  onNewton: () => void;
}

/** The plot's legend and its numbers at one place: a row for every method, whose name shows or hides its line. */
export function ComparisonReadout(props: Props) {
  const { caption, made, curves, hidden, abscissa, place, stale, onToggle, onNewton } = props;
  const instead = (method: Minimiser): ComponentChildren => {
    const refusal = made.refusals.find((one) => one.method === method);
    if (refusal) return t('plots.comparison.refused', refusalParams(refusal.status));
    if (stale) return null;
    if (method !== 'newton' || newtonWanted.value) return t('plots.comparison.computing');
    return (
      <button type="button" onClick={onNewton}>
        {t('plots.comparison.addNewton')}
      </button>
    );
  };
  const row = (method: Minimiser) => {
    const curve = curves.find((one) => one.method === method);
    return curve ? <Numbers point={pointAt(curve, abscissa, place)} /> : <td colSpan={4}>{instead(method)}</td>;
  };
  return (
    <table class="comparison-numbers comparison-readout">
      <caption>{caption}</caption>
      <thead>
        <tr>
          <th scope="col">{t('methods.label')}</th>
          <th scope="col">{heightUnit('gap')}</th>
          <th scope="col">{heightUnit('gradient')}</th>
          <th scope="col">{t(`plots.comparison.${abscissa === 'iterations' ? 'stoppedAfter' : 'iterations'}`)}</th>
          <th scope="col">{t('plots.comparison.milliseconds')}</th>
        </tr>
      </thead>
      <tbody>
        {minimisers.map((method) => (
          <tr key={method}>
            <th scope="row">
              <button
                type="button"
                aria-pressed={!hidden.includes(method)}
                disabled={!curves.some((curve) => curve.method === method)}
                onClick={() => onToggle(method)}
              >
                <Swatch method={method} />
                {t(`methods.name.${method}`)}
              </button>
            </th>
            {row(method)}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Numbers({ point: { iteration, milliseconds, gap, gradient } }: { point: CurvePoint }) {
  return (
    <>
      <td>{gapText(gap)}</td>
      <td>{formatNumber(gradient, 2)}</td>
      <td>{iteration}</td>
      <td>{formatNumber(milliseconds, 2)}</td>
    </>
  );
}

export function Swatch({ method }: { method: Minimiser }) {
  const { colour, dash } = methodStyles[method];
  return (
    <svg class="swatch" viewBox="0 0 32 4" aria-hidden="true">
      <line
        x1="0"
        y1="2"
        x2="32"
        y2="2"
        stroke={`var(${colour})`}
        stroke-width="2.5"
        stroke-dasharray={dash.join(' ')}
      />
    </svg>
  );
}

/** The curves' heights in a line, for those who hear them. */
export function readOff(curves: readonly Curve[], ordinate: Ordinate, abscissa: Abscissa, place: number): string {
  const heights = curves.map(
    (curve) => `${t(`methods.name.${curve.method}`)} ${heightText(pointAt(curve, abscissa, place), ordinate)}`,
  );
  return `${heightUnit(ordinate)}: ${heights.join('; ')}`;
}

export function heightUnit(ordinate: Ordinate): string {
  return ordinate === 'gap' ? `${t('plots.comparison.gapShort')}, J` : `${t('plots.gradient')}, N`;
}

export function heightText({ gap, gradient }: CurvePoint, ordinate: Ordinate): string {
  return ordinate === 'gap' ? gapText(gap) : formatNumber(gradient, 2);
}

export function gapText(gap: number | null): string {
  return gap === null ? t('plots.comparison.rounding') : formatNumber(gap, 2);
}
