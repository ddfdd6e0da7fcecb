import { formatQuantity } from '../../../../lib/format.ts';
import { symbolCommand } from '../../../../notation/macros.ts';
import { Formula } from '../../../../views/equations/formula.tsx';
import type { FigureSession } from '../../figures/figure_session.ts';
import './trick.css';

/** E and Ẽ at the cursor: the one under the other, equal right after a local step. */
export function Energies({ figure }: { figure: FigureSession }) {
  const frame = figure.frame.value;
  const event = frame?.events[frame.half_step];
  return (
    <p class="energies">
      {(['surrogate', 'objective'] as const).map((id) => (
        <span key={id}>
          <Formula tex={symbolCommand(id)} /> = {event ? formatQuantity(event[id], 'J', 5) : '…'}
        </span>
      ))}
    </p>
  );
}
