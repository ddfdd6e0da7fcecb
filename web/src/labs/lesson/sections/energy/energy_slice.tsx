import { LineChart } from '../../../../views/charts/line_chart.tsx';
import { Phrase } from '../../../../views/equations/prose.tsx';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { useInspection } from '../../figures/use_inspection.ts';

interface Props {
  words: Record<'summary' | 'x' | 'y' | 'energy' | 'parabola', string>;
  caption: string;
}

const oneSpring: FigureSettings = { scene: 'single-spring-horizontal', selection: { spring: 0, vertex: 1 } };

/** m: where vertex 1 is put, on the line through vertex 0 and beyond. */
const places = Array.from({ length: 61 }, (_, at) => (at - 30) / 15);

/** m: the spring is on the right side of vertex 0, or on the left. */
function signedLength(p: Float64Array): number {
  return Math.hypot(p[3] - p[0], p[4] - p[1]) * (p[3] < p[0] ? -1 : 1);
}

const pointsToAsk = () => places.map((x) => Float64Array.of(-0.5, 0, 0, -0.5 + x, 0, 0));

/** The energy of one spring along a line, beside the parabola that is left when d is held. */
export function EnergySlice({ words, caption }: Props) {
  const figure = useFigure(oneSpring);
  const seen = useInspection(figure, pointsToAsk);
  const { k } = figure.parameters.value;
  const rest = figure.r.value[0];
  const spring = seen?.evaluations.map(({ potential }, at) => [places[at], potential] as const) ?? [];
  // d points to the right: ½k |x - d|²
  const parabola = seen ? places.map((x) => [x, 0.5 * k * (x - rest) ** 2] as const) : [];
  return (
    <Figure figure={figure} pictures={['net']} sliders={['k']} caption={caption}>
      <LineChart
        series={[
          { name: words.energy, points: spring },
          { name: words.parabola, points: parabola },
        ]}
        x={{ label: <Phrase text={words.x} />, range: [-2, 2] }}
        y={{ label: <Phrase text={words.y} />, range: [0, 1.5 * k] }}
        {...(seen && { cursor: signedLength(seen.frame.p) })}
        summary={words.summary}
      />
    </Figure>
  );
}
