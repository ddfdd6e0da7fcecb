import { inLanguage } from '../../../../app/messages/in_language.ts';
import { formatFixed } from '../../../../lib/format.ts';
import { row } from '../../../../lib/vector.ts';
import { Formula } from '../../../../views/equations/formula.tsx';
import type { FigureSession } from '../../figures/figure_session.ts';
import { acceleration, velocity } from './differences.ts';
import { en } from './en.ts';
import { swinging } from './trail.tsx';
import { zh } from './zh.ts';

const { raw } = String;

/** The three positions of the swinging mass, and the velocity and acceleration that they amount to. */
export function DifferenceTable({ figure }: { figure: FigureSession }) {
  const words = inLanguage({ en, zh });
  const here = figure.checkpoint();
  const frame = figure.frame.value;
  if (!here || !frame) return <div class="difference-table-empty" />;
  const { p_curr, p_prev } = here;
  const { delta_t } = figure.parameters.value;
  const rows = [
    { tex: raw`\sympPrev_${swinging}`, values: p_prev, unit: 'm', decimals: 3 },
    { tex: raw`\sympCurr_${swinging}`, values: p_curr, unit: 'm', decimals: 3 },
    { tex: raw`\symp_${swinging}`, values: frame.p, unit: 'm', decimals: 3 },
    { tex: raw`\symvelocity_${swinging}`, values: velocity(p_curr, p_prev, delta_t), unit: 'm/s', decimals: 2 },
    { tex: raw`\syma_${swinging}`, values: acceleration(frame.p, p_curr, p_prev, delta_t), unit: 'm/s²', decimals: 2 },
  ];
  return (
    <table class="numbers difference-table">
      <caption>{words.swing.table}</caption>
      <thead>
        <tr>
          <td />
          <th scope="col">x</th>
          <th scope="col">y</th>
          <td />
        </tr>
      </thead>
      <tbody>
        {rows.map(({ tex, values, unit, decimals }) => (
          <tr key={tex}>
            <th scope="row">
              <Formula tex={tex} />
            </th>
            {row(values, swinging)
              .slice(0, 2)
              .map((value, axis) => (
                <td key={axis}>{formatFixed(value, decimals)}</td>
              ))}
            <td>{unit}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
