import { Formula } from '../../../../views/equations/formula.tsx';
import { MatrixTable } from '../../../../views/matrices/matrix_table.tsx';
import { denseValues, gram } from '../../figures/dense_values.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { useInspection } from '../../figures/use_inspection.ts';
import { PlainMatrix } from './plain_matrix.tsx';

const patch: FigureSettings = { scene: 'patch', parameters: { w: 1e4 }, selection: { spring: 0, vertex: 2 } };

/** C and CᵀC of a net with two pins. */
export function SelectedRows({ caption }: { caption: string }) {
  const figure = useFigure(patch);
  const seen = useInspection(figure);
  return (
    <Figure figure={figure} pictures={['net']} caption={caption}>
      <div class="pins-room pins-room-tall">
        {seen && (
          <>
            <MatrixTable
              figure={figure}
              symbol="C"
              values={denseValues(seen.C)}
              name={<Formula tex={String.raw`\symC`} />}
            />
            <PlainMatrix
              figure={figure}
              caption={<Formula tex={String.raw`\symC^{\mathrm T}\symC`} />}
              values={gram(denseValues(seen.C), seen.C.columns)}
              size={seen.C.columns}
              vertices={Array.from(seen.m, (_, i) => i)}
            />
          </>
        )}
      </div>
    </Figure>
  );
}
