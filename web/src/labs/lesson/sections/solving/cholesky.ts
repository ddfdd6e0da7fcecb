import type { SmallMatrix } from './small_matrix.ts';

/** L with L Lᵀ = Q, as by hand, row by row; or the row whose pivot is not positive, so that there is none. Only Q's lower half is read. */
export function cholesky(Q: SmallMatrix): { L: number[][] } | { failedAt: number; pivot: number } {
  const L: number[][] = [];
  for (let i = 0; i < Q.length; i++) {
    const row = new Array<number>(Q.length).fill(0);
    for (let j = 0; j < i; j++) row[j] = (Q[i][j] - dot(row, L[j], j)) / L[j][j];
    const pivot = Q[i][i] - dot(row, row, i);
    if (!(pivot > 0)) return { failedAt: i, pivot };
    row[i] = Math.sqrt(pivot);
    L.push(row);
  }
  return { L };
}

/** The solution of L x = b, from the first row down. */
export function substituteForwards(L: SmallMatrix, b: readonly number[]): number[] {
  const x = new Array<number>(b.length).fill(0);
  for (let i = 0; i < b.length; i++) x[i] = (b[i] - dot(L[i], x, i)) / L[i][i];
  return x;
}

/** The solution of Lᵀ p = x, from the last row up. */
export function substituteBackwards(L: SmallMatrix, x: readonly number[]): number[] {
  const p = new Array<number>(x.length).fill(0);
  for (let i = x.length - 1; i >= 0; i--) {
    let rest = x[i];
    for (let j = i + 1; j < x.length; j++) rest -= L[j][i] * p[j];
    p[i] = rest / L[i][i];
  }
  return p;
}

/** Of the first `count` components. */
function dot(a: readonly number[], b: readonly number[], count: number): number {
  let sum = 0;
  for (let index = 0; index < count; index++) sum += a[index] * b[index];
  return sum;
}

/** All of Q⁻¹, a column for each unit vector. */
export function inverse(L: SmallMatrix): SmallMatrix {
  const columns = L.map((_, j) => {
    const unit = L.map((_, i) => (i === j ? 1 : 0));
    return substituteBackwards(L, substituteForwards(L, unit));
  });
  return columns; // symmetric: its columns are its rows
}
