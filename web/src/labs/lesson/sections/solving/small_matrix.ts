import type { Triplets } from '../../../../solver/module.ts';

/** A matrix as rows of numbers: for nets so small that a page can show it whole. */
export type SmallMatrix = readonly (readonly number[])[];

/** A solver's matrix with its zeros. */
export function smallMatrix({ rows, columns, i, j, value }: Triplets): SmallMatrix {
  const matrix = Array.from({ length: rows }, () => new Array<number>(columns).fill(0));
  for (const [entry, row] of i.entries()) matrix[row][j[entry]] = value[entry];
  return matrix;
}

/** (row, column) of every entry that is not exactly zero. */
export function nonZeros(matrix: SmallMatrix): [number, number][] {
  return matrix.flatMap((row, i) => row.flatMap((value, j): [number, number][] => (value === 0 ? [] : [[i, j]])));
}
