import type { Evaluation } from '../../../../solver/protocol.ts';
import type { SmallMatrix } from '../solving/small_matrix.ts';

/** J: Ẽ(p, d) from the terms of E at p. `v` is A p, `d` the vectors held, both #E×3, m. */
export function surrogate({ objective, potential }: Evaluation, k: number, v: Float64Array, d: Float64Array): number {
  return objective - potential + 0.5 * k * v.reduce((sum, x, c) => sum + (x - d[c]) ** 2, 0);
}

/** J: ½ tr(pᵀQp) − tr(pᵀb), what is left of Ẽ(p, d) without the terms in which p does not stand. p is #V×3, m; b a row for every vertex, N. */
export function withoutConstants(Q: SmallMatrix, b: readonly (readonly number[])[], p: Float64Array): number {
  return [0, 1, 2].reduce((total, axis) => {
    const rows = Q.map((row, i) => {
      const Qp = row.reduce((sum, entry, j) => sum + entry * p[3 * j + axis], 0);
      return p[3 * i + axis] * (0.5 * Qp - b[i][axis]);
    });
    return total + rows.reduce((sum, value) => sum + value, 0);
  }, 0);
}
