import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatQuantity } from '../../../../lib/format.ts';
import type { Frame } from '../../../../solver/frame.ts';
import { LineChart } from '../../../../views/charts/line_chart.tsx';
import { Phrase } from '../../../../views/equations/prose.tsx';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { type Seen, useInspection } from '../../figures/use_inspection.ts';
import { smallMatrix } from '../solving/small_matrix.ts';
import type { en } from './en.ts';
import { springVectors } from './spring_vectors.ts';
import { surrogate, withoutConstants } from './without_constants.ts';

/** A long step and a soft pin: constants no larger than the parabola is deep. At a global half-step, where p solves Q p = b. */
const swinging: FigureSettings = {
  scene: 'single-spring-horizontal',
  parameters: { delta_t: 0.2, w: 100 },
  selection: { spring: null, vertex: 1 },
  opening: [
    { kind: 'play', steps: 2 },
    { kind: 'next_half_step' },
    { kind: 'next_half_step' },
    { kind: 'next_half_step' },
  ],
};

/** m: how far vertex 1 is lifted from where it is. */
const offsets = Array.from({ length: 41 }, (_, at) => (at - 20) / 20);

const pointsToAsk = ({ p }: Frame) =>
  offsets.map((offset) => {
    const point = p.slice();
    point[4] += offset;
    return point;
  });

/** Ẽ(p, d) along a line, with the terms in which p does not stand and without. */
export function LiftedParabola({ words }: { words: typeof en.constants }) {
  const figure = useFigure(swinging);
  const seen = useInspection(figure, pointsToAsk);
  const d = seen?.frame.d;
  const curves = seen && d ? curvesOf(seen, d) : { whole: [], left: [] };
  const difference = curves.whole.length > 0 ? curves.whole[0][1] - curves.left[0][1] : null;

  function curvesOf({ frame, evaluations, equations, ...matrices }: Seen, held: Float64Array) {
    const { k } = figure.parameters.value;
    const points = pointsToAsk(frame);
    const Q = smallMatrix(matrices.Q);
    const b = equations.map((equation) => equation.b);
    return {
      whole: offsets.map(
        (x, at) => [x, surrogate(evaluations[at], k, springVectors(figure, points[at]), held)] as const,
      ),
      left: offsets.map((x, at) => [x, withoutConstants(Q, b, points[at])] as const),
    };
  }

  return (
    <Figure figure={figure} pictures={['net']} caption={words.caption}>
      <LineChart
        series={[
          { name: words.whole, points: curves.whole },
          { name: words.left, points: curves.left },
        ]}
        x={{ label: words.x, range: [-1, 1] }}
        y={{ label: <Phrase text={words.y} /> }}
        summary={words.summary}
      />
      <p class="report">
        {difference !== null && fillTemplate(words.difference, { difference: formatQuantity(difference, 'J', 4) })}
      </p>
    </Figure>
  );
}
