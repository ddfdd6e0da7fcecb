import type { Seen } from '../../figures/use_inspection.ts';
import { cholesky, substituteBackwards, substituteForwards } from '../solving/cholesky.ts';
import type { SmallMatrix } from '../solving/small_matrix.ts';

/** What a global step with some Q comes to: positions, #V×3, m, or the row at which Cholesky finds that there is no L. */
export type GlobalStep = { p: Float64Array } | { failedAt: number; pivot: number };

/** Q p = b with any Q, and the b of the moment seen. */
export function globalStepWith(Q: SmallMatrix, { equations }: Pick<Seen, 'equations'>): GlobalStep {
  const factor = cholesky(Q);
  if (!('L' in factor)) return factor;
  const columns = [0, 1, 2].map((axis) => {
    const b = equations.map((equation) => equation.b[axis]);
    return substituteBackwards(factor.L, substituteForwards(factor.L, b));
  });
  return { p: Float64Array.from(Q.flatMap((_, i) => columns.map((column) => column[i]))) };
}

/** m: how far apart two sets of positions are at most, #V×3 each. */
export function farthest(a: Float64Array, b: Float64Array): number {
  const distances = Array.from({ length: a.length / 3 }, (_, i) =>
    Math.hypot(a[3 * i] - b[3 * i], a[3 * i + 1] - b[3 * i + 1], a[3 * i + 2] - b[3 * i + 2]),
  );
  return Math.max(...distances);
}
