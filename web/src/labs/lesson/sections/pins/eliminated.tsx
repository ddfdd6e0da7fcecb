import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { useInspection } from '../../figures/use_inspection.ts';
import { sumOf } from '../matrices/terms_of_q.ts';
import { PlainMatrix } from './plain_matrix.tsx';

const held: FigureSettings = { scene: 'triangle', selection: { spring: 0, vertex: 1 } };

/** Q without a penalty, and what is left of it when the pinned vertices are no unknowns. */
export function Eliminated({ words }: { words: Record<'caption' | 'left', string> }) {
  const figure = useFigure(held);
  const seen = useInspection(figure);
  return (
    <Figure figure={figure} pictures={['net']} sliders={['k', 'mass_scale']} caption={words.caption}>
      <div class="pins-room">
        {seen && (
          <PlainMatrix
            figure={figure}
            symbol="Q"
            caption={words.left}
            values={sumOf(['springs', 'masses'], seen, figure.parameters.value)}
            size={seen.Q.rows}
            vertices={Array.from(seen.m, (_, i) => i)}
            struck={Array.from(seen.frame.pinned)}
          />
        )}
      </div>
    </Figure>
  );
}
