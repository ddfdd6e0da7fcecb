import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatQuantity } from '../../../../lib/format.ts';
import { Formula } from '../../../../views/equations/formula.tsx';
import { MatrixProduct } from '../../../../views/matrices/matrix_product.tsx';
import { denseValues } from '../../figures/dense_values.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSession, FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { type Seen, useInspection } from '../../figures/use_inspection.ts';

const { raw } = String;

const hanging: FigureSettings = {
  scene: 'triangle',
  selection: { spring: 1, vertex: 2 },
  opening: [{ kind: 'play', steps: 4 }, { kind: 'next_half_step' }, { kind: 'next_half_step' }],
};

/** A p = v of a hanging triangle, and the springs' energy for its d as a sum and as a trace. */
export function SpringsProduct({ caption, check }: { caption: string; check: string }) {
  const figure = useFigure(hanging);
  const seen = useInspection(figure);
  return (
    <Figure figure={figure} pictures={['net']} caption={caption}>
      <div class="matrices-room">{seen && <Product figure={figure} seen={seen} />}</div>
      <p class="matrices-check">{seen?.frame.d && fillTemplate(check, bothSides(figure, seen, seen.frame.d))}</p>
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

/** #E×3, m: A p. */
function springVectors(figure: FigureSession, p: Float64Array): Float64Array {
  const { E } = figure.scene.value;
  return Float64Array.from({ length: (3 * E.length) / 2 }, (_, c) => {
    const e = Math.floor(c / 3);
    return p[3 * E[2 * e] + (c % 3)] - p[3 * E[2 * e + 1] + (c % 3)];
  });
}

/** ½k Σ‖(p_i − p_j) − d_ij‖², and ½k tr((Ap − d)ᵀ(Ap − d)) by columns. */
function bothSides(figure: FigureSession, { frame }: Seen, d: Float64Array): { sum: string; trace: string } {
  const { k } = figure.parameters.value;
  const missed = springVectors(figure, frame.p).map((x, c) => x - d[c]);
  const rows = Array.from({ length: missed.length / 3 }, (_, e) => Math.hypot(...missed.subarray(3 * e, 3 * e + 3)));
  const sum = rows.reduce((total, length) => total + length ** 2, 0);
  const diagonal = [0, 1, 2].map((axis) => missed.reduce((total, x, c) => (c % 3 === axis ? total + x * x : total), 0));
  const trace = diagonal[0] + diagonal[1] + diagonal[2];
  return { sum: formatQuantity(0.5 * k * sum, 'J'), trace: formatQuantity(0.5 * k * trace, 'J') };
}
