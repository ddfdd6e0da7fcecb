import type { Problem } from '../../../../solver/protocol.ts';
import type { SmallMatrix } from '../solving/small_matrix.ts';

/** One entry on its way into Q, and what asks for it: a spring, or a vertex for its mass or its pin. */
export interface Triplet {
  i: number;
  j: number;
  /** N/m. */
  value: number;
  from: { kind: 'spring' | 'mass' | 'pin'; index: number };
}

/** Every contribution to Q = k AᵀA + M/Δt² + w CᵀC, in the solver's order. pinned: #pinned, rows of V. */
export function tripletsOfQ(
  { E, m }: Pick<Problem, 'E' | 'm'>,
  pinned: ArrayLike<number>,
  { k, delta_t, w, mass_scale }: { k: number; delta_t: number; w: number; mass_scale: number },
): Triplet[] {
  const springs = Array.from({ length: E.length / 2 }, (_, e): Triplet[] => {
    const [i, j] = [E[2 * e], E[2 * e + 1]];
    const from = { kind: 'spring', index: e } as const;
    return [
      { i, j: i, value: k, from },
      { i: j, j, value: k, from },
      { i, j, value: -k, from },
      { i: j, j: i, value: -k, from },
    ];
  });
  const masses = Array.from(m, (mass, i): Triplet => {
    return { i, j: i, value: (mass * mass_scale) / delta_t ** 2, from: { kind: 'mass', index: i } };
  });
  const pins = Array.from(pinned, (i): Triplet => ({ i, j: i, value: w, from: { kind: 'pin', index: i } }));
  return [...springs.flat(), ...masses, ...pins];
}

/** What a second triplet for the same place does to the first. */
export type Repetition = 'add' | 'overwrite';

/** The n×n matrix with those triplets inserted one after the other; null where nothing was. */
export function assembled(
  n: number,
  triplets: readonly Triplet[],
  repetition: Repetition,
): readonly (readonly (number | null)[])[] {
  const matrix = Array.from({ length: n }, () => new Array<number | null>(n).fill(null));
  for (const { i, j, value } of triplets) {
    const before = matrix[i][j];
    matrix[i][j] = repetition === 'add' && before !== null ? before + value : value;
  }
  return matrix;
}

/** The same with a 0 where nothing was. */
export function withZeros(matrix: readonly (readonly (number | null)[])[]): SmallMatrix {
  return matrix.map((row) => row.map((value) => value ?? 0));
}

/**
 * How many stored entries move up by one place when the triplets are inserted one by one into a compressed matrix, row after row, as A(i,j) += v
 * does. setFromTriplets counts what each row will hold first, and so moves every entry a fixed number of times.
 */
export function movesByInsertion(n: number, triplets: readonly Pick<Triplet, 'i' | 'j'>[]): number {
  const stored: number[] = []; // n i + j, ascending
  let moves = 0;
  for (const { i, j } of triplets) {
    const key = n * i + j;
    const at = firstNotBelow(stored, key);
    if (stored[at] === key) continue;
    moves += stored.length - at;
    stored.splice(at, 0, key);
  }
  return moves;
}

/** Index of the first element of an ascending list that is not below `key`. */
function firstNotBelow(ascending: readonly number[], key: number): number {
  let [low, high] = [0, ascending.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ascending[middle] < key) low = middle + 1;
    else high = middle;
  }
  return low;
}
