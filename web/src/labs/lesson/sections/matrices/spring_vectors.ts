import type { FigureSession } from '../../figures/figure_session.ts';

/** #E×3, m: A p. */
export function springVectors(figure: FigureSession, p: Float64Array): Float64Array {
  const { E } = figure.scene.value;
  return Float64Array.from({ length: (3 * E.length) / 2 }, (_, c) => {
    const e = Math.floor(c / 3);
    return p[3 * E[2 * e] + (c % 3)] - p[3 * E[2 * e + 1] + (c % 3)];
  });
}
