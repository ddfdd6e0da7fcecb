import { fillTemplate } from '../../../../lib/fill_template.ts';
import { LineChart } from '../../../../views/charts/line_chart.tsx';
import { Phrase } from '../../../../views/equations/prose.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useTrajectories } from '../../figures/use_trajectories.ts';
import type { en } from './en.ts';

const lowestVertex = 7;
const steps = 60;
const delta_t = 1 / 30; // s
const rounds = [1, 3, 10, 50];

const falls = rounds.map(
  (iterations): FigureSettings => ({ scene: 'patch', parameters: { k: 2000, delta_t, iterations } }),
);

/** The patch let go at rest, with more and more rounds a time step. */
export function PeanutButter({ words }: { words: typeof en.peanut }) {
  const trajectories = useTrajectories(falls, steps);
  const series = rounds.map((iterations, at) => ({
    name: fillTemplate(words.rounds, { iterations }),
    points: (trajectories?.[at] ?? []).map(({ step, p }) => [step * delta_t, p[3 * lowestVertex + 1]] as const),
  }));
  return (
    <div class="figure">
      <LineChart
        series={series}
        x={{ label: <Phrase text={words.time} />, range: [0, steps * delta_t] }}
        y={{ label: <Phrase text={words.height} /> }}
        summary={words.summary}
      />
    </div>
  );
}
