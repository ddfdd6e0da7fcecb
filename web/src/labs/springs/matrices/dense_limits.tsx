import { parameters, scene } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatNumber } from '../../../lib/format.ts';
import { formatTime } from '../../../lib/format_time.ts';
import { grouped } from '../../../lib/grouped.ts';
import type { SolvingCall } from '../../../solver/time_solving.ts';
import { LineChart, type Series } from '../../../views/charts/line_chart.tsx';
import { Phrase } from '../../../views/equations/prose.tsx';
import { growth, largest, unknownsWithin, verticesInMemory } from './dense_growth.ts';
import { roomWords } from './room_words.ts';
import type { NetTimes } from './use_net_times.ts';

/** ms: who changes a parameter waits for a factorisation, and no longer than that. */
const patience_ms = 1000;

const range = { n: [50, 20_000], ms: [1e-4, 1e4] } as const;

interface Props extends NetTimes {
  /** Unknowns of the present scene. */
  n: number | null;
}

/** From how many unknowns on dense matrices make no sense on this computer, and how that is told. */
export function DenseLimits({ times, failure, n }: Props) {
  const words = roomWords().storage;
  const { iterations, delta_t } = parameters.value;
  const substitution = largest(times, 'dense_substitute');
  const factorisation = largest(times, 'dense_factorise');
  const springsPerVertex = scene.value.E.length / 2 / scene.value.m.length;
  const budget_ms = 1000 * delta_t;
  return (
    <section class="dense-limits">
      <h3>{words.limitTitle}</h3>
      {failure !== null && <p role="alert">{fillTemplate(words.failed, { reason: failure })}</p>}
      <ul>
        {substitution && (
          <li>
            <Phrase
              text={fillTemplate(words.limits.time, {
                n: about(unknownsWithin(substitution, budget_ms / iterations)),
                budget: formatTime(budget_ms, 2),
                measured: formatTime(substitution.milliseconds, 2),
                at: substitution.n,
              })}
            />
          </li>
        )}
        {factorisation && (
          <li>
            <Phrase
              text={fillTemplate(words.limits.factor, {
                n: about(unknownsWithin(factorisation, patience_ms)),
                measured: formatTime(factorisation.milliseconds, 2),
                at: factorisation.n,
              })}
            />
          </li>
        )}
        <li>
          <Phrase
            text={fillTemplate(words.limits.memory, {
              ratio: formatNumber(springsPerVertex, 2),
              n: about(verticesInMemory(springsPerVertex)),
            })}
          />
        </li>
        {n !== null && <li>{fillTemplate(words.limits.here, { n: grouped(n) })}</li>}
      </ul>
      <LineChart
        series={[
          seriesOf(times, 'dense_substitute', words.chart.dense, growth.dense_substitute),
          seriesOf(times, 'sparse_substitute', words.chart.sparse, null),
        ]}
        x={{ label: words.chart.x, logarithmic: true, range: range.n }}
        y={{ label: words.chart.y, logarithmic: true, range: range.ms }}
        {...(n === null ? {} : { cursor: n })}
        summary={words.chart.summary}
      />
    </section>
  );
}

/** Two digits: more of an extrapolation would pretend. */
function about(n: number): string {
  return grouped(Number(n.toPrecision(2)));
}

/** What was measured, and the power of n by which it goes on. */
function seriesOf(times: NetTimes['times'], call: SolvingCall, name: string, exponent: number | null): Series {
  const points = times
    .filter((time) => time.call === call)
    .map(({ n, milliseconds }): [number, number] => [n, milliseconds]);
  const last = points.at(-1);
  if (!last || exponent === null) return { name, points, dots: true };
  const law = range.n.map((n): [number, number] => [n, last[1] * (n / last[0]) ** exponent]);
  return { name, points, dots: true, law };
}
