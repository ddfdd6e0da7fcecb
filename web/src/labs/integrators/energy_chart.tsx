import { useState } from 'preact/hooks';
import { inLanguage } from '../../app/messages/in_language.ts';
import type { SideBySide } from '../../app/side_by_side.ts';
import { fillTemplate } from '../../lib/fill_template.ts';
import { LineChart, type Series } from '../../views/charts/line_chart.tsx';
import { en } from './en.ts';
import { calmRange, shownSamples, total } from './energies.ts';
import { LabelledSelect } from './labelled_select.tsx';
import { zh } from './zh.ts';

interface Props {
  run: SideBySide;
  names: readonly string[];
}

/** Of all methods the total energy, or of one of them what it consists of. */
export function EnergyChart({ run, names }: Props) {
  const words = inLanguage({ en, zh }).energy;
  const [chosen, choose] = useState<number | null>(null);
  const of = names.length === 1 ? 0 : chosen !== null && chosen < names.length ? chosen : null;
  const curves = run.energies.value.map(shownSamples);
  const series: Series[] =
    of === null
      ? names.map((name, at) => ({ name, points: (curves[at] ?? []).map((one) => [one.time, total(one)]) }))
      : [
          { name: words.kinetic, points: (curves[of] ?? []).map(({ time, kinetic }) => [time, kinetic]) },
          { name: words.springs, points: (curves[of] ?? []).map(({ time, springs }) => [time, springs]) },
          { name: words.gravity, points: (curves[of] ?? []).map(({ time, external }) => [time, external]) },
          { name: words.total, points: (curves[of] ?? []).map((one) => [one.time, total(one)]) },
        ];
  const begun = series.some(({ points }) => points.length > 1);
  const range =
    begun && of === null ? calmRange(series.map(({ points }) => points.map(([, energy]) => energy))) : undefined;
  return (
    <section aria-labelledby="energy-heading">
      <div class="evidence-heading">
        <h3 id="energy-heading">{words.heading}</h3>
        {names.length > 1 && (
          <LabelledSelect
            label={words.shown}
            value={of === null ? '' : String(of)}
            options={[['', words.totals], ...names.map((name, at) => [String(at), name] as const)]}
            onChange={(value) => choose(value === '' ? null : Number(value))}
          />
        )}
      </div>
      {begun ? (
        <LineChart
          series={series}
          x={{ label: words.time }}
          y={{
            label: of === null ? words.totalOf : fillTemplate(words.termsOf, { name: names[of] }),
            ...(range && { range }),
          }}
          summary={of === null ? words.summaryTotals : words.summaryTerms}
        />
      ) : (
        <p class="evidence-empty">{words.empty}</p>
      )}
    </section>
  );
}
