import { inLanguage } from '../../app/messages/in_language.ts';
import type { SideBySide } from '../../app/side_by_side.ts';
import { LineChart } from '../../views/charts/line_chart.tsx';
import { en } from './en.ts';
import { shownTime } from './energies.ts';
import { LabelledSelect } from './labelled_select.tsx';
import { zh } from './zh.ts';

interface Props {
  run: SideBySide;
  names: readonly string[];
}

/** How far the others are from one of them. */
export function DistanceChart({ run, names }: Props) {
  const words = inLanguage({ en, zh });
  const reference = run.reference.value;
  const { value: distances } = run.distances;
  const end = distances[reference]?.at(-1)?.time ?? 0;
  const series = names.map((name, at) => ({
    name,
    points: (distances[at] ?? [])
      .filter(({ time }) => at !== reference && time > end - shownTime)
      .map(({ time, distance }) => [time, distance] as const),
  }));
  const begun = series.some(({ points }) => points.length > 1);
  return (
    <section aria-labelledby="distance-heading">
      <div class="evidence-heading">
        <h3 id="distance-heading">{words.error.heading}</h3>
        {names.length > 1 && (
          <LabelledSelect
            label={words.error.from}
            value={String(reference)}
            options={names.map((name, at) => [String(at), name] as const)}
            onChange={(value) => run.measureBy(Number(value))}
          />
        )}
      </div>
      {begun ? (
        <LineChart
          series={series}
          x={{ label: words.energy.time }}
          y={{ label: words.error.label, logarithmic: true }}
          summary={words.error.summary}
        />
      ) : (
        <p class="evidence-empty">{names.length > 1 ? words.energy.empty : words.error.alone}</p>
      )}
    </section>
  );
}
