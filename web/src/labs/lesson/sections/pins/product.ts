/** A matrix with all its entries, row-major. */
export interface Dense {
  rows: number;
  columns: number;
  values: Float64Array;
}

/** a · b; null where a has not as many columns as b has rows. */
export function product(a: Dense, b: Dense): Dense | null {
  if (a.columns !== b.rows) return null;
  const values = new Float64Array(a.rows * b.columns);
  for (let i = 0; i < a.rows; i++) {
    for (let k = 0; k < a.columns; k++) {
      for (let j = 0; j < b.columns; j++)
        values[i * b.columns + j] += a.values[i * a.columns + k] * b.values[k * b.columns + j];
    }
  }
  return { rows: a.rows, columns: b.columns, values };
}

export function transposed({ rows, columns, values }: Dense): Dense {
  const flipped = Float64Array.from(values, (_, at) => values[(at % rows) * columns + Math.floor(at / rows)]);
  return { rows: columns, columns: rows, values: flipped };
}
