import { formatLength, formatQuantity } from '../../../../lib/format.ts';
import { Formula } from '../../../../views/equations/formula.tsx';
import { MatrixTable } from '../../../../views/matrices/matrix_table.tsx';
import { denseValues } from '../../figures/dense_values.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSession } from '../../figures/figure_session.ts';
import { type Seen, useInspection } from '../../figures/use_inspection.ts';

const { raw } = String;

type Quantity = 'drift' | 'force' | 'rounding';

interface Props {
  figure: FigureSession;
  caption: string;
  words: Record<Quantity, string>;
}

/** A pin held by a penalty of the reader's choice: C, Q, how far it yields, and what that costs. */
export function WeakPin({ figure, caption, words }: Props) {
  const seen = useInspection(figure);
  return (
    <Figure figure={figure} pictures={['net']} sliders={['w']} caption={caption}>
      <div class="pins-room pins-room-pair">{seen && <Tables figure={figure} seen={seen} />}</div>
      <dl class="pins-numbers">
        {seen &&
          numbersOf(seen, figure.parameters.value.w).map(([name, value]) => (
            <div key={name}>
              <dt>{words[name]}</dt>
              <dd>{value}</dd>
            </div>
          ))}
      </dl>
    </Figure>
  );
}

function Tables({ figure, seen }: { figure: FigureSession; seen: Seen }) {
  return (
    <>
      <MatrixTable figure={figure} symbol="C" values={denseValues(seen.C)} name={<Formula tex={raw`\symC`} />} />
      <MatrixTable figure={figure} symbol="Q" values={denseValues(seen.Q)} name={<Formula tex={raw`\symQ`} />} />
    </>
  );
}

function numbersOf({ frame }: Seen, w: number): [Quantity, string][] {
  const pin = frame.pinned[0];
  const drift = Math.hypot(...[0, 1, 2].map((axis) => frame.p[3 * pin + axis] - frame.targets[axis]));
  const size = Math.hypot(...frame.targets.subarray(0, 3));
  return [
    ['drift', formatLength(drift)],
    ['force', formatQuantity(w * drift, 'N')],
    ['rounding', formatQuantity(w * size * Number.EPSILON, 'N', 1)],
  ];
}
