import { formatLength, formatQuantity } from '../../../../lib/format.ts';
import type { Frame } from '../../../../solver/frame.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import type { Drawing } from '../../figures/spring_picture.tsx';
import { useFigure } from '../../figures/use_figure.ts';
import { useInspection } from '../../figures/use_inspection.ts';

interface Props {
  words: Record<'caption' | 'length' | 'rest' | 'gap' | 'fromGap' | 'fromSolver', string>;
}

const oneSpring: FigureSettings = {
  scene: 'single-spring-horizontal',
  selection: { spring: null, vertex: 1 }, // the spring's glow would hide the vector
  opening: [{ kind: 'play', steps: 9 }],
};

/** m: all of the circle about the pin. */
const window = { left: -1.65, right: 0.75, bottom: -1.2, top: 1.1 };

const pointsToAsk = ({ p }: Frame) => [p];

/** The spring's vector, the circle of all vectors of its rest length, and the closest of them. */
export function ClosestVector({ words }: Props) {
  const figure = useFigure(oneSpring);
  const seen = useInspection(figure, pointsToAsk);
  const rest = figure.r.value[0];
  const length = seen && lengthOfSpring(seen.frame.p);
  const gap = length === null ? null : Math.abs(length - rest);
  const rows: [string, string][] =
    seen && length !== null && gap !== null
      ? [
          [words.length, formatLength(length)],
          [words.rest, formatLength(rest)],
          [words.gap, formatLength(gap)],
          [words.fromGap, formatQuantity(0.5 * figure.parameters.value.k * gap ** 2, 'J')],
          [words.fromSolver, formatQuantity(seen.evaluations[0].potential, 'J')],
        ]
      : [];
  return (
    <Figure figure={figure} pictures={['net']} behind={circle} window={window} sliders={['k']} caption={words.caption}>
      <dl class="closest-numbers">
        {rows.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
    </Figure>
  );
}

function lengthOfSpring(p: Float64Array): number {
  return Math.hypot(p[3] - p[0], p[4] - p[1]);
}

function circle({ figure, frame, plane }: Drawing) {
  const { p } = frame;
  const rest = figure.r.value[0];
  const length = lengthOfSpring(p);
  const along = length > 0 ? [(p[3] - p[0]) / length, (p[4] - p[1]) / length] : [1, 0];
  const end = [p[0] + rest * along[0], p[1] + rest * along[1], 0];
  const [fixed, free, closest] = [plane.place(p, 0), plane.place(p, 1), plane.place(end, 0)];
  return (
    <>
      <circle class="closest-circle" cx={fixed[0]} cy={fixed[1]} r={plane.length(rest)} data-about="r" />
      <line class="closest-vector" x1={fixed[0]} y1={fixed[1]} x2={closest[0]} y2={closest[1]} data-about="d" />
      <line class="closest-gap" x1={closest[0]} y1={closest[1]} x2={free[0]} y2={free[1]} />
    </>
  );
}
