import { LineChart } from '../../../../views/charts/line_chart.tsx';
import { Phrase } from '../../../../views/equations/prose.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useTrajectories } from '../../figures/use_trajectories.ts';
import type { en } from './en.ts';

/** N: the largest force left unbalanced. */
export const tolerance = 0.1;
const steps = 8;
const stiffnesses = [100, 200, 400, 800, 1600, 2400, 3200]; // N/m

const patches = stiffnesses.map(
  (k): FigureSettings => ({ scene: 'patch', parameters: { k, iterations: 1000, stop_gradient: tolerance } }),
);

/** How many rounds a time step takes to get that far, for softer and stiffer springs. */
export function EnoughRounds({ words }: { words: typeof en.enough }) {
  const last = useTrajectories(patches, steps)?.flatMap((frames) => frames.slice(-1)) ?? [];
  const points = last.map(({ stiffnessNumber, iterations }) => [stiffnessNumber, iterations] as const);
  return (
    <div class="figure">
      <LineChart
        series={[{ name: words.series, points, dots: true }]}
        x={{ label: <Phrase text={words.kappa} /> }}
        y={{ label: <Phrase text={words.rounds} /> }}
        summary={words.summary}
      />
    </div>
  );
}
