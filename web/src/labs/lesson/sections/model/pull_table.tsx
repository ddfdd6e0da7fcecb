import { formatFixed } from '../../../../lib/format.ts';
import type { FigureSession } from '../../figures/figure_session.ts';
import { springPulls } from '../../figures/spring_pulls.ts';

interface Props {
  figure: FigureSession;
  words: { table: string; vertex: string; sum: string };
}

/** What the springs pull at every vertex of the figure, and that it adds up to nothing. */
export function PullTable({ figure, words }: Props) {
  const frame = figure.frame.value;
  const scene = figure.scene.value;
  if (!frame) return null;
  const pulls = springPulls(scene, figure.parameters.value.k, figure.r.value, frame.p);
  const sum = pulls.reduce(([x, y], pull) => [x + pull[0], y + pull[1]]);
  // Pulls that cancel leave rounding behind, and its sign.
  const shown = (newtons: number) => formatFixed(Math.abs(newtons) < 0.005 ? 0 : newtons, 2);
  return (
    <table class="numbers pulls">
      <caption>{words.table}</caption>
      <thead>
        <tr>
          <th scope="col">{words.vertex}</th>
          <th scope="col">x</th>
          <th scope="col">y</th>
        </tr>
      </thead>
      <tbody>
        {pulls.map(([x, y], vertex) => (
          <tr key={vertex} data-vertex={vertex}>
            <th scope="row">{vertex}</th>
            <td>{shown(x)}</td>
            <td>{shown(y)}</td>
          </tr>
        ))}
      </tbody>
      <tfoot>
        <tr>
          <th scope="row">{words.sum}</th>
          <td>{shown(sum[0])}</td>
          <td>{shown(sum[1])}</td>
        </tr>
      </tfoot>
    </table>
  );
}
