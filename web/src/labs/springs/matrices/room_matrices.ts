import type { Elimination, Factor, LinearlyImplicitMatrices, Matrices } from '../../../solver/matrices.ts';
import type { Triplets } from '../../../solver/module.ts';
import type { SparsityModel } from '../../../views/sparsity/sparsity_view.tsx';
import { byCoordinates, listed, numbered } from './axes.ts';
import { modelOf } from './model_of.ts';
import { freeVertices, type Numbering } from './numbering.ts';
import { roomWords } from './room_words.ts';
import { signKinds } from './sign_kinds.ts';

export const matrixNames = ['A', 'M', 'C', 'AtA', 'Q', 'L', 'P', 'K', 'implicit', 'Phat'] as const;
export type MatrixName = (typeof matrixNames)[number];

export const fillColours: SparsityModel['kinds'] = [['--symbol-Q'], ['--symbol-d']];

/**
 * The lab's matrices as the view shows them. L and P once the solver's elimination is there, and L only where it was computed; K and what is made
 * of it once they are there.
 */
export function roomMatrices(
  { A, M, C, AtA, Q }: Matrices,
  elimination: Elimination | null,
  linearlyImplicit: LinearlyImplicitMatrices | null,
  { E, vertexCount, pinned }: Numbering,
): Record<MatrixName, SparsityModel | null> {
  const springs = numbered('spring', E.length / 2);
  const vertices = numbered('vertex', vertexCount);
  const coordinates = byCoordinates(vertices);
  const order = elimination && listed(elimination.order);
  const factor = elimination?.factor ?? null;
  return {
    A: modelOf({ E, symbol: 'A', triplets: A, rows: springs, columns: vertices }),
    M: modelOf({ E, symbol: 'M', triplets: M, rows: vertices, columns: vertices }),
    C: modelOf({ E, symbol: 'C', triplets: C, rows: listed(pinned, true), columns: vertices }),
    AtA: modelOf({ E, symbol: 'A', triplets: AtA, rows: vertices, columns: vertices, unit: null }),
    Q: modelOf({ E, symbol: 'Q', triplets: Q, rows: vertices, columns: vertices }),
    L:
      factor &&
      order &&
      modelOf({
        E,
        symbol: 'L',
        triplets: factor,
        rows: order,
        columns: order,
        kinds: { of: (entry) => (isFill(factor, entry) ? 1 : 0), colours: fillColours },
        remark: (entry, pattern) => (entry >= 0 && pattern.kind[entry] === 1 ? roomWords().entry.fill : ''),
      }),
    P:
      elimination &&
      order &&
      modelOf({
        E,
        symbol: 'P',
        triplets: permutation(elimination.order, vertexCount),
        rows: order,
        columns: vertices,
      }),
    K:
      linearlyImplicit &&
      modelOf({
        E,
        symbol: 'K',
        triplets: linearlyImplicit.K,
        rows: coordinates,
        columns: coordinates,
        kinds: signKinds,
      }),
    implicit:
      linearlyImplicit &&
      modelOf({
        E,
        symbol: 'K',
        triplets: linearlyImplicit.system,
        rows: coordinates,
        columns: coordinates,
        unit: 'kg',
        kinds: signKinds,
      }),
    Phat:
      linearlyImplicit &&
      modelOf({
        E,
        symbol: 'Phat',
        triplets: linearlyImplicit.P,
        rows: byCoordinates(listed(freeVertices({ vertexCount, pinned }))),
        columns: coordinates,
      }),
  };
}

export function isFill({ born }: Pick<Factor, 'born'>, entry: number): boolean {
  return born[entry] > 0;
}

/** Row c picks the vertex that is eliminated as the c-th. */
function permutation(order: Int32Array, columns: number): Triplets {
  return {
    rows: order.length,
    columns,
    i: Int32Array.from(order.keys()),
    j: order,
    value: new Float64Array(order.length).fill(1),
  };
}
