import type { Triplets } from '../../../../solver/module.ts';
import type { Inspection } from '../../../../solver/protocol.ts';
import { denseValues, gram } from '../../figures/dense_values.ts';

export const terms = ['springs', 'masses', 'pins'] as const;
export type Term = (typeof terms)[number];

/** #V×#V, N/m: the chosen terms of k AᵀA + M/Δt² + w CᵀC. */
export function sumOf(
  chosen: readonly Term[],
  { A, M, C }: Pick<Inspection, 'A' | 'M' | 'C'>,
  { k, delta_t, w }: { k: number; delta_t: number; w: number },
): Float64Array {
  const squared = (X: Triplets, factor: number) => gram(denseValues(X), X.columns).map((entry) => factor * entry);
  const parts: Record<Term, () => Float64Array> = {
    springs: () => squared(A, k),
    masses: () => denseValues(M).map((mass) => mass / delta_t ** 2),
    pins: () => squared(C, w),
  };
  return chosen
    .map((term) => parts[term]())
    .reduce((sum, part) => sum.map((entry, at) => entry + part[at]), new Float64Array(A.columns ** 2));
}
