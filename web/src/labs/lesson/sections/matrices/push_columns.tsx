import { useState } from 'preact/hooks';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatFixed } from '../../../../lib/format.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSession, FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { type Seen, useInspection } from '../../figures/use_inspection.ts';
import { cholesky, substituteBackwards, substituteForwards } from '../solving/cholesky.ts';
import { type SmallMatrix, smallMatrix } from '../solving/small_matrix.ts';
import type { en } from './en.ts';
import { newtonMatrix } from './newton_matrix.ts';

/** With a w, so that the pin is a row like the others. */
const hanging: FigureSettings = {
  scene: 'triangle',
  parameters: { w: 1e4 },
  selection: { spring: 1, vertex: 2 },
  opening: [{ kind: 'play', steps: 4 }],
};

const axes = ['x', 'y', 'z'] as const;
/** Which vertex is pushed, and with how many N. */
const pushed = 2;
const force = 10;

/** How all vertices answer a push along one axis: to the global step, and to a step of Newton's method. */
export function PushColumns({ words }: { words: typeof en.columns }) {
  const figure = useFigure(hanging);
  const seen = useInspection(figure);
  const [axis, setAxis] = useState(0);
  return (
    <Figure figure={figure} pictures={['net']} caption={words.caption}>
      <fieldset class="choices">
        <legend>{fillTemplate(words.push, { force, vertex: pushed })}</legend>
        {axes.map((name, at) => (
          <label key={name}>
            <input type="radio" name="push" checked={at === axis} onChange={() => setAxis(at)} />
            {name}
          </label>
        ))}
      </fieldset>
      <div class="matrices-room push-columns">
        {seen && (
          <>
            <Answer caption={words.global} moves={globalAnswer(seen, axis)} />
            <Answer caption={words.newton} moves={newtonAnswer(figure, seen, axis)} />
          </>
        )}
      </div>
    </Figure>
  );
}

/** `moves`: #V×3, m; null where the matrix is not positive definite. */
function Answer({ caption, moves }: { caption: string; moves: readonly number[] | null }) {
  const vertices = Array.from({ length: (moves ?? []).length / 3 }, (_, i) => i);
  return (
    <table class="numbers">
      <caption>{caption}</caption>
      <thead>
        <tr>
          <td />
          {axes.map((name) => (
            <th key={name} scope="col">
              {name}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {vertices.map((i) => (
          <tr key={i}>
            <th scope="row" data-vertex={i}>
              {i}
            </th>
            {axes.map((name, at) => (
              <td key={name}>{moves && written(moves[3 * i + at])}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** Q⁻¹ of one column of b; the other two columns are not even asked. */
function globalAnswer({ Q, m }: Seen, axis: number): number[] | null {
  const column = solved(
    smallMatrix(Q),
    Array.from(m, (_, i) => (i === pushed ? force : 0)),
  );
  return column?.flatMap((x) => axes.map((_, at) => (at === axis ? x : 0))) ?? null;
}

function newtonAnswer(figure: FigureSession, { m, frame }: Seen, axis: number): number[] | null {
  const net = { E: figure.scene.value.E, r: figure.r.value, m, pinned: frame.pinned };
  const push = Array.from(frame.p, (_, row) => (row === 3 * pushed + axis ? force : 0));
  return solved(newtonMatrix(net, frame.p, figure.parameters.value), push);
}

function solved(matrix: SmallMatrix, b: readonly number[]): number[] | null {
  const factor = cholesky(matrix);
  return 'L' in factor ? substituteBackwards(factor.L, substituteForwards(factor.L, b)) : null;
}

/** In mm. */
function written(metres: number): string {
  return metres === 0 ? '0' : formatFixed(1e3 * metres, 2);
}
