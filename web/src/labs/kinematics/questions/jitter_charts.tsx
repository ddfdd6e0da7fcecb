import type { Sweep } from '../../../solver/ik_sweep.ts';
import { LineChart } from '../../../views/charts/line_chart.tsx';
import { questionWords } from './question_words.ts';
import type { SweepName, Sweeps } from './use_sweeps.ts';

interface Props {
  sweeps: Sweeps;
  chosen: readonly SweepName[];
  /** The target that is looked at. */
  at: number;
}

/** Of the chosen two: how far a joint turned from one target to the next, and how far off the arm was. */
export function JitterCharts({ sweeps, chosen, at }: Props) {
  const words = questionWords().jitter;
  const series = (values: (sweep: Sweep) => readonly number[]) =>
    chosen.map((name) => ({
      name: words.names[name],
      points: values(sweeps[name]).map((value, target) => [target + 1, value] as const),
    }));
  const last = sweeps.warm.errors.length;
  const x = { label: words.target, range: [1, last] as const };
  return (
    <div class="jitter-charts">
      <LineChart
        series={series(({ turns }) => [...turns].map((turn) => (turn * 180) / Math.PI)).map(({ name, points }) => ({
          name,
          points: points.slice(1), // to the first target the arm comes from elsewhere
        }))}
        x={x}
        y={{ label: words.turn, logarithmic: true, range: [0.1, 200] }}
        cursor={at + 1}
        summary={words.turnSummary}
      />
      <LineChart
        series={series(({ errors }) => [...errors])}
        x={x}
        y={{ label: words.error, logarithmic: true, range: [1e-6, 10] }}
        cursor={at + 1}
        summary={words.errorSummary}
      />
    </div>
  );
}
