import { inLanguage } from '../../../../app/messages/in_language.ts';
import type { Frame } from '../../../../solver/frame.ts';
import { LineChart } from '../../../../views/charts/line_chart.tsx';
import { Phrase } from '../../../../views/equations/prose.tsx';
import type { FigureSession } from '../../figures/figure_session.ts';
import { useInspection } from '../../figures/use_inspection.ts';
import { en } from './en.ts';
import { free } from './landscape_grid.ts';
import { zh } from './zh.ts';

/** m from the pin, to either side: 1.6 rest lengths. */
const farthest = 1.6;
const samples = 65;
const offsets = Array.from({ length: samples }, (_, at) => farthest * ((2 * at) / (samples - 1) - 1));

/** p with the free vertex on the level of the pin, at each of the offsets. */
function pointsThroughPin({ p, targets: [x, y] }: Frame): Float64Array[] {
  return offsets.map((offset) => {
    const point = p.slice();
    point.set([x + offset, y, 0], 3 * free);
    return point;
  });
}

/** The energy of one spring along a line through its pinned end: no parabola. */
export function TwoWells({ figure }: { figure: FigureSession }) {
  const words = inLanguage({ en, zh }).nonlinear;
  const seen = useInspection(figure, pointsThroughPin);
  const points = seen?.evaluations.map(({ potential }, at) => [offsets[at], potential] as const) ?? [];
  return (
    <div class="figure plain-chart">
      <LineChart
        series={[{ name: words.spring, points }]}
        x={{ label: <Phrase text={words.offset} />, range: [-farthest, farthest] }}
        y={{ label: <Phrase text={words.energy} /> }}
        summary={words.summary}
      />
    </div>
  );
}
