import { formatFixed } from '../../../../lib/format.ts';
import type { Frame } from '../../../../solver/frame.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { centralDifferences, pointsAround } from '../../figures/finite_differences.ts';
import { springPulls } from '../../figures/spring_pulls.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { useInspection } from '../../figures/use_inspection.ts';
import './force_check.css';

interface Props {
  words: Record<'caption' | 'table' | 'formula' | 'differences' | 'wrong', string>;
}

const swinging: FigureSettings = {
  scene: 'triangle',
  selection: { spring: 0, vertex: 1 },
  opening: [{ kind: 'play', steps: 5 }],
};
const vertex = 1;
const pointsToAsk = ({ p }: Frame) => pointsAround(p, vertex);

/** The springs' pull by its formula, and by differences of the solver's energy with either sign. */
export function ForceCheck({ words }: Props) {
  const figure = useFigure(swinging);
  const seen = useInspection(figure, pointsToAsk);
  const differences = seen && centralDifferences(seen.evaluations.map(({ potential }) => potential));
  const rows: [string, readonly number[], string][] =
    seen && differences
      ? [
          [
            words.formula,
            springPulls(figure.scene.value, figure.parameters.value.k, figure.r.value, seen.frame.p)[vertex],
            '',
          ],
          [words.differences, differences.map((difference) => -difference), '✓'],
          [words.wrong, differences, '✗'],
        ]
      : [];
  return (
    <Figure figure={figure} pictures={['net']} sliders={['k']} caption={words.caption}>
      <table class="numbers force-check">
        <caption>{words.table}</caption>
        <thead>
          <tr>
            <td />
            <th scope="col">x</th>
            <th scope="col">y</th>
            <td />
          </tr>
        </thead>
        <tbody>
          {rows.map(([name, newtons, verdict]) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              {newtons.map((value, axis) => (
                <td key={axis}>{formatFixed(value, 2)}</td>
              ))}
              <td>{verdict}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </Figure>
  );
}
