import { useState } from 'preact/hooks';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatFixed } from '../../../../lib/format.ts';
import { Formula } from '../../../../views/equations/formula.tsx';
import { denseValues, gram } from '../../figures/dense_values.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { type Seen, useInspection } from '../../figures/use_inspection.ts';
import type { en } from './en.ts';
import { type Dense, product, transposed } from './product.ts';

const { raw } = String;

const patch: FigureSettings = {
  scene: 'patch',
  parameters: { w: 1e4 },
  selection: { spring: null, vertex: 1 },
  opening: [{ kind: 'play', steps: 3 }],
};

const lefts = { C: raw`\symC`, Ct: raw`\symC^{\mathrm T}`, CtC: raw`\symC^{\mathrm T}\symC` } as const;
type Left = keyof typeof lefts;
const rights = ['positions', 'list'] as const;
type Right = (typeof rights)[number];

/** The reader multiplies: does it fit, and what comes of it? */
export function FittingProduct({ words }: { words: typeof en.product }) {
  const figure = useFigure(patch);
  const seen = useInspection(figure);
  const [left, setLeft] = useState<Left>('C');
  const [right, setRight] = useState<Right>('positions');
  return (
    <Figure figure={figure} pictures={['net']} caption={words.caption}>
      <fieldset class="choices">
        <legend>{words.left}</legend>
        {(Object.keys(lefts) as Left[]).map((id) => (
          <label key={id}>
            <input type="radio" name="left" checked={id === left} onChange={() => setLeft(id)} />
            <Formula tex={lefts[id]} />
          </label>
        ))}
      </fieldset>
      <fieldset class="choices">
        <legend>{words.right}</legend>
        {rights.map((id) => (
          <label key={id}>
            <input type="radio" name="right" checked={id === right} onChange={() => setRight(id)} />
            {words[id]}
          </label>
        ))}
      </fieldset>
      <div class="pins-product">{seen && <Result seen={seen} left={left} right={right} words={words} />}</div>
    </Figure>
  );
}

function Result({ seen, left, right, words }: { seen: Seen; left: Left; right: Right; words: typeof en.product }) {
  const { frame } = seen;
  const [a, b] = [leftOf(seen, left), rightOf(seen, right)];
  const made = product(a, b);
  const sizes = { rows: a.rows, columns: a.columns, others: b.rows };
  if (!made) return <p class="report">{fillTemplate(words.misfit, sizes)}</p>;
  const everyVertex = made.rows === frame.p.length / 3;
  const vertices = everyVertex ? Array.from(seen.m, (_, i) => i) : Array.from(frame.pinned);
  return (
    <>
      <p class="report">{fillTemplate(everyVertex ? words.fits : words.small, sizes)}</p>
      <table class="numbers plain-matrix">
        <caption>{words.result}</caption>
        <thead>
          <tr>
            <td />
            {['x', 'y', 'z'].map((axis) => (
              <th key={axis} scope="col">
                {axis}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {vertices.map((vertex, row) => (
            <tr key={vertex}>
              <th scope="row" data-vertex={vertex}>
                {vertex}
              </th>
              {[0, 1, 2].map((axis) => (
                <td key={axis}>{written(made.values[3 * row + axis])}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </>
  );
}

function leftOf({ C }: Seen, left: Left): Dense {
  const chosen: Dense = { rows: C.rows, columns: C.columns, values: denseValues(C) };
  if (left === 'C') return chosen;
  if (left === 'Ct') return transposed(chosen);
  return { rows: C.columns, columns: C.columns, values: gram(chosen.values, C.columns) };
}

function rightOf({ frame: { p, targets } }: Seen, right: Right): Dense {
  const values = right === 'positions' ? p : targets;
  return { rows: values.length / 3, columns: 3, values };
}

/** In m. */
function written(metres: number): string {
  return metres === 0 ? '0' : formatFixed(metres, 3);
}
