import type { Triplets } from '../../../solver/module.ts';

/** All entries, row-major, zeros too. */
export function denseValues({ rows, columns, i, j, value }: Triplets): Float64Array {
  const values = new Float64Array(rows * columns);
  value.forEach((entry, at) => {
    values[i[at] * columns + j[at]] += entry;
  });
  return values;
}

/** Xᵀ X of a row-major matrix, columns × columns. */
export function gram(values: Float64Array, columns: number): Float64Array {
  const product = new Float64Array(columns * columns);
  for (let row = 0; row < values.length / columns; row++) {
    for (let a = 0; a < columns; a++) {
      for (let b = 0; b < columns; b++)
        product[a * columns + b] += values[row * columns + a] * values[row * columns + b];
    }
  }
  return product;
}
