import { Formula } from '../../../../views/equations/formula.tsx';
import { MatrixProduct } from '../../../../views/matrices/matrix_product.tsx';
import { denseValues } from '../../figures/dense_values.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSession, FigureSettings } from '../../figures/figure_session.ts';
import type { Seen } from '../../figures/use_inspection.ts';
import { springVectors } from './spring_vectors.ts';

const { raw } = String;

/** Opens after a local step: before it there is no d. */
export const hanging: FigureSettings = {
  scene: 'triangle',
  selection: { spring: 1, vertex: 2 },
  opening: [{ kind: 'play', steps: 4 }, { kind: 'next_half_step' }, { kind: 'next_half_step' }],
};

interface Props {
  figure: FigureSession;
  seen: Seen | null;
  caption: string;
}

/** A p = v. */
export function SpringsProduct({ figure, seen, caption }: Props) {
  return (
    <Figure figure={figure} pictures={['net']} caption={caption}>
      <div class="matrices-room">{seen && <Product figure={figure} seen={seen} />}</div>
    </Figure>
  );
}

function Product({ figure, seen }: { figure: FigureSession; seen: Seen }) {
  return (
    <MatrixProduct
      figure={figure}
      left={{ symbol: 'A', values: denseValues(seen.A), name: <Formula tex={raw`\symA`} /> }}
      right={{ symbol: 'p', values: seen.frame.p, name: <Formula tex={raw`\symp`} /> }}
      result={{ symbol: 'v', values: springVectors(figure, seen.frame.p), name: <Formula tex={raw`\symv`} /> }}
    />
  );
}
