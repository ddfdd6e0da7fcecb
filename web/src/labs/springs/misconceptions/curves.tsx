import { useEffect, useState } from 'preact/hooks';
import { inLanguage } from '../../../app/messages/in_language.ts';
import type { SideBySide } from '../../../app/side_by_side.ts';
import { Choice } from '../../../lib/choice.tsx';
import { LineChart } from '../../../views/charts/line_chart.tsx';
import { en } from './en.ts';
import { type Measure, measures, type Point, rangeAround, rangeOfStill, thinned } from './measures.ts';
import { useRecord } from './use_record.ts';
import { zh } from './zh.ts';

/** Time steps that the chart has room for, 8 s of the course's: by then every symptom is there. */
const window = 240;
/** Time steps between two points of a curve. */
const gap = 3;

interface Props {
  run: SideBySide;
  names: readonly [string, string];
  initial: Measure;
  /** Whether the mistaken net leaves every scale, so that the right one's is kept. */
  explodes: boolean;
  /** Which net is right. */
  right: number;
}

/** Height, energy or time needed of both nets, against time steps. */
export function Curves({ run, names, initial, explodes, right }: Props) {
  const words = inLanguage({ en, zh }).measures;
  const [measure, choose] = useState(initial);
  const record = useRecord(run, window);
  useEffect(() => choose(initial), [initial]);

  run.energies.value; // as often as a reader can follow
  const measured: Record<Measure, (net: number) => readonly Point[]> = {
    height: (net) => record.current[net]?.heights ?? [],
    energy: (net) => record.current[net]?.energies ?? [],
    time: (net) => record.current[net]?.times ?? [],
  };
  const series = names.map((name, net) => ({
    name,
    points: thinned(
      measured[measure](net).filter(([step]) => step <= window),
      gap,
    ),
  }));
  const range = explodes ? rangeAround(series[right].points) : rangeOfStill(series.map(({ points }) => points));
  return (
    <section class="curves">
      <Choice
        label={words.label}
        options={measures.map((one) => [one, words.names[one]] as const)}
        chosen={measure}
        onChoose={choose}
      />
      <LineChart
        series={series}
        x={{ label: words.x, range: [0, window] }}
        y={{ label: words[measure], ...(range && { range }) }}
        summary={words.summary[measure]}
      />
    </section>
  );
}
