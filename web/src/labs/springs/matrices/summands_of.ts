import type { LinearlyImplicitMatrices } from '../../../solver/matrices.ts';

/** Springs alone, with the masses, and without the pinned vertices. */
export const stages = ['K', 'system', 'constrained'] as const;
export type Stage = (typeof stages)[number];

/** What every spring adds at a stage, #E×9, and what stands on the diagonal before: see sumOfSprings. */
export function summandsOf(
  stage: Stage,
  { stiffness, resistance }: Pick<LinearlyImplicitMatrices, 'stiffness' | 'resistance'>,
  m: Float64Array,
  delta_t: number,
): { blocks: Float64Array; diagonal: Float64Array | null } {
  if (stage === 'K') return { blocks: stiffness.map((entry) => -entry), diagonal: null };
  return {
    blocks: stiffness.map((entry, at) => delta_t * (delta_t * entry + (resistance ? resistance[at] : 0))),
    diagonal: Float64Array.from({ length: 3 * m.length }, (_, row) => m[Math.floor(row / 3)]),
  };
}
