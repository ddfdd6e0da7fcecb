import { substituteBackwards, substituteForwards } from './cholesky.ts';
import type { SmallMatrix } from './small_matrix.ts';

/** A moment of solving L Lᵀ p = b by hand: step s has s rows behind it, first n downwards, then n upwards. */
export interface SubstitutionMoment {
  /** n each; null: not known yet. */
  x: readonly (number | null)[];
  p: readonly (number | null)[];
  /** The row that this step solved; null before the first. */
  solved: { pass: 'forwards' | 'backwards'; row: number } | null;
}

/** Where the two passes stand after so many steps (0 … 2n). */
export function substitutionAt(L: SmallMatrix, b: readonly number[], step: number): SubstitutionMoment {
  const n = L.length;
  const x = substituteForwards(L, b);
  const p = substituteBackwards(L, x);
  const down = Math.min(step, n);
  const up = step - down;
  return {
    x: x.map((value, row) => (row < down ? value : null)),
    p: p.map((value, row) => (row >= n - up ? value : null)),
    solved: up > 0 ? { pass: 'backwards', row: n - up } : down > 0 ? { pass: 'forwards', row: down - 1 } : null,
  };
}

/** TeX of how the row just solved was solved, e.g. x_2 = (b_2 − L_{20} x_0 − L_{21} x_1)/L_{22}. */
export function rowFormula(n: number, { pass, row }: NonNullable<SubstitutionMoment['solved']>): string {
  const downwards = pass === 'forwards';
  const [unknown, known] = downwards ? ['x', String.raw`\symb`] : [String.raw`\symp`, 'x'];
  const others = Array.from({ length: n }, (_, other) => other).filter((o) => (downwards ? o < row : o > row));
  const terms = others.map((other) => {
    const [i, j] = downwards ? [row, other] : [other, row];
    return `- ${entry(i, j)}\\,${unknown}_{${other}}`;
  });
  return String.raw`${unknown}_{${row}} = \frac{${known}_{${row}} ${terms.join(' ')}}{${entry(row, row)}}`;
}

function entry(i: number, j: number): string {
  return String.raw`\symL_{${i}${j}}`;
}
