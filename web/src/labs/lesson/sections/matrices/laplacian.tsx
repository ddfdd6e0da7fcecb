import { Formula } from '../../../../views/equations/formula.tsx';
import { denseValues, gram } from '../../figures/dense_values.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { useInspection } from '../../figures/use_inspection.ts';
import { PlainMatrix } from '../pins/plain_matrix.tsx';

const patch: FigureSettings = { scene: 'patch', selection: { spring: null, vertex: 4 } };

/** AᵀA beside the net whose graph it describes. */
export function Laplacian({ caption }: { caption: string }) {
  const figure = useFigure(patch);
  const seen = useInspection(figure);
  return (
    <Figure figure={figure} pictures={['net']} caption={caption}>
      <div class="matrices-room">
        {seen && (
          <PlainMatrix
            figure={figure}
            caption={<Formula tex={String.raw`\symA^{\mathrm T}\symA`} />}
            values={gram(denseValues(seen.A), seen.A.columns)}
            size={seen.A.columns}
            vertices={Array.from(seen.m, (_, i) => i)}
          />
        )}
      </div>
    </Figure>
  );
}
