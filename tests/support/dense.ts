import type { Triplets } from '../../web/src/solver/module.ts';

/** A small matrix as rows of numbers. */
export function dense({ rows, columns, i, j, value }: Triplets): number[][] {
  const matrix = Array.from({ length: rows }, () => new Array<number>(columns).fill(0));
  value.forEach((entry, t) => {
    matrix[i[t]][j[t]] += entry;
  });
  return matrix;
}

/** The sum of each row: the matrix times a vector of ones. */
export function rowSums(matrix: Triplets): number[] {
  return dense(matrix).map((row) => row.reduce((a, b) => a + b, 0));
}
