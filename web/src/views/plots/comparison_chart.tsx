import { useMemo, useState } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { type Comparison, comparison, timeStep } from '../../app/comparison.ts';
import { t } from '../../app/messages/index.ts';
import { parameters } from '../../app/state.ts';
import { Choice } from '../../lib/choice.tsx';
import { formatQuantity } from '../../lib/format.ts';
import type { Minimiser } from '../../solver/module.ts';
import { stopOf } from '../../solver/stop_of.ts';
import {
  type Abscissa,
  abscissaRange,
  comparisonCurves,
  firstPlace,
  type Minimum,
  type Ordinate,
} from './comparison_curves.ts';
import { ComparisonPlot } from './comparison_plot.ts';
import { ComparisonReadout, readOff } from './comparison_readout.tsx';
import { ComparisonStops, ruleText } from './comparison_stops.tsx';
import { ComparisonTable } from './comparison_table.tsx';
import { PlaceSlider } from './place_slider.tsx';
import { usePlot } from './use_plot.ts';
import 'uplot/dist/uPlot.min.css';
import '../../notation/colours.css';
import './plots.css';
import './comparison.css';

/** The gap that each method leaves to the minimum of one time step, or the gradient, against iterations or against time, and where each ends. */
export function ComparisonChart({ actions }: { actions: Actions }) {
  const made = comparison.value;
  if (!made || made.runs.length === 0) return <p class="objective-note">{t('plots.comparison.invite')}</p>;
  return <Curves made={made} stale={made.of !== timeStep.value} actions={actions} />;
}

function Curves({ made, stale, actions }: { made: Comparison; stale: boolean; actions: Actions }) {
  const [abscissa, setAbscissa] = useState<Abscissa>('iterations');
  const [ordinate, setOrdinate] = useState<Ordinate>('gap');
  const [hidden, setHidden] = useState<readonly Minimiser[]>([]);
  const [pointed, point] = useState<number | null>(null);

  const { curves, minimum } = useMemo(() => comparisonCurves(made.runs, made.rounding), [made]);
  const { iterations, stop_gradient, stop_decrease } = parameters.value;
  const stops = useMemo(() => {
    const rules = { iterations, stop_gradient, stop_decrease };
    return new Map(made.runs.map((run) => [run.method, stopOf(run, rules)] as const));
  }, [made, iterations, stop_gradient, stop_decrease]);
  const range = useMemo(() => abscissaRange(curves, abscissa, iterations), [curves, abscissa, iterations]);
  const place = pointed ?? firstPlace(curves, abscissa, iterations);
  const inspected = abscissa === 'iterations' ? Math.round(place) : place;
  const drawn = useMemo(
    () => ({
      curves: curves.filter(({ method }) => !hidden.includes(method)),
      stops,
      abscissa,
      ordinate,
      range,
      inspected,
      stale,
    }),
    [curves, hidden, stops, abscissa, ordinate, range, inspected, stale],
  );
  const host = usePlot((element) => new ComparisonPlot(element, point), drawn);
  const { step } = made.of;

  return (
    <>
      <div class="comparison-heading">
        <Choice
          label={t('plots.comparison.height')}
          options={[
            ['gap', t('plots.comparison.gapShort')],
            ['gradient', t('plots.gradient')],
          ]}
          chosen={ordinate}
          onChoose={setOrdinate}
        />
        <Choice
          label={t('plots.comparison.against')}
          options={[
            ['iterations', t('plots.comparison.iterations')],
            ['milliseconds', t('plots.comparison.milliseconds')],
          ]}
          chosen={abscissa}
          onChoose={(chosen) => {
            setAbscissa(chosen);
            point(null);
          }}
        />
      </div>
      <p class="objective-note">{t(`plots.comparison.${ordinate}`)}</p>
      <PlaceSlider
        abscissa={abscissa}
        range={range}
        place={inspected}
        text={`${placeText(abscissa, inspected)}: ${readOff(drawn.curves, ordinate, abscissa, inspected)}`}
        onChoose={point}
      />
      <div
        ref={host}
        class="objective-plot"
        role="img"
        aria-label={t(`plots.comparison.label.${ordinate}`, { step, methods: drawn.curves.length })}
      />
      <p class="objective-axis comparison-axis">
        <span>
          <span class="dot" /> {t('plots.comparison.mark', { rule: ruleText() })}
        </span>
        <span>{t(`plots.comparison.${abscissa}`)}</span>
      </p>
      {stale && <p class="objective-note">{t('plots.stale', { step })}</p>}
      <ComparisonReadout
        caption={placeText(abscissa, inspected)}
        made={made}
        curves={curves}
        hidden={hidden}
        abscissa={abscissa}
        place={inspected}
        stale={stale}
        onToggle={(method) =>
          setHidden(hidden.includes(method) ? hidden.filter((other) => other !== method) : [...hidden, method])
        }
        onNewton={() => actions.compareNewton()}
      />
      <p class="objective-note">{minimumText(minimum)}</p>
      <ComparisonStops curves={curves} stops={stops} />
      <ComparisonTable
        step={step}
        caption={minimumText(minimum)}
        curves={curves}
        ordinate={ordinate}
        runs={made.runs}
      />
    </>
  );
}

function placeText(abscissa: Abscissa, place: number): string {
  return abscissa === 'iterations'
    ? t('plots.comparison.afterIterations', { place })
    : t('plots.comparison.afterTime', { place: formatQuantity(place, 'ms', 2) });
}

/** What E* is: the minimum is known no better than by the best of the methods. */
function minimumText({ method, iteration, converged }: Minimum): string {
  const name = t(`methods.name.${method}`);
  return t(converged ? 'plots.comparison.minimum' : 'plots.comparison.lowest', { name, iteration });
}
