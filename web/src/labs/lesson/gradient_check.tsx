import { fillTemplate } from '../../lib/fill_template.ts';
import { columnScale, formatInColumn, formatQuantity } from '../../lib/format.ts';
import type { Frame } from '../../solver/frame.ts';
import type { Evaluation } from '../../solver/protocol.ts';
import type { FigureSession } from './figures/figure_session.ts';
import { centralDifferences, h, pointsAround } from './figures/finite_differences.ts';
import { type Seen, useInspection } from './figures/use_inspection.ts';
import { lessonWords } from './lesson_words.ts';

/** What a printed E can be made of: its right terms, J, at a point, and all that they are made of. */
export type AtPoint = Evaluation &
  Pick<Seen, 'p_curr' | 'p_prev' | 'm'> &
  Pick<Frame, 'pinned' | 'targets'> & { p: Float64Array; k: number; delta_t: number; w: number };

interface Props {
  figure: FigureSession;
  /** J: E as it is printed. */
  printedEnergy: (at: AtPoint) => number;
}

/** ∂E/∂p of the selected vertex from the solver, beside differences of the right E and of the printed one. */
export function GradientCheck({ figure, printedEnergy }: Props) {
  const words = lessonWords().slip;
  const seen = useInspection(figure, pointsToAsk);
  if (!seen) return <p class="slip-check-empty" />;

  const { evaluations, frame, p_curr, p_prev, m } = seen;
  const { k, delta_t, w } = figure.parameters.value;
  const vertex = chosenVertex(frame);
  const points = pointsToAsk(frame);
  const known = { p_curr, p_prev, m, pinned: frame.pinned, targets: frame.targets, k, delta_t, w };
  const gradient = [...evaluations[0].gradient.subarray(3 * vertex, 3 * vertex + 2)];
  const ofRight = centralDifferences(evaluations.map(({ objective }) => objective));
  const ofPrinted = centralDifferences(
    evaluations.map((evaluation, at) => printedEnergy({ ...evaluation, ...known, p: points[at] })),
  );
  const scale = columnScale(Math.max(...[...gradient, ...ofRight, ...ofPrinted].map(Math.abs)), 'N');
  const rows = [
    { name: words.gradient, values: gradient, verdict: '' },
    { name: words.ofRight, values: ofRight, verdict: same(ofRight, gradient) ? '✓' : '✗' },
    { name: words.ofPrinted, values: ofPrinted, verdict: same(ofPrinted, gradient) ? '✓' : '✗' },
  ];
  return (
    <div class="slip-check">
      <table class="numbers">
        <caption>{fillTemplate(words.check, { i: vertex, h: formatQuantity(h, 'm', 1), unit: scale.unit })}</caption>
        <thead>
          <tr>
            <td />
            <th scope="col">x</th>
            <th scope="col">y</th>
            <td />
          </tr>
        </thead>
        <tbody>
          {rows.map(({ name, values, verdict }) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              {values.map((value, axis) => (
                <td key={axis}>{formatInColumn(value, scale)}</td>
              ))}
              <td class={verdict === '✗' ? 'slip-wrong' : 'slip-right'}>{verdict}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p>{same(ofPrinted, gradient) ? words.agrees : words.differs}</p>
    </div>
  );
}

function chosenVertex({ vertexEquation }: Frame): number {
  return vertexEquation?.vertex ?? 0;
}

function pointsToAsk(frame: Frame): Float64Array[] {
  return pointsAround(frame.p, chosenVertex(frame));
}

/** Equal but for what differences of numbers of this size leave behind. */
function same(a: readonly number[], b: readonly number[]): boolean {
  return a.every((value, axis) => Math.abs(value - b[axis]) <= 1e-4 * (1 + Math.abs(value) + Math.abs(b[axis])));
}
