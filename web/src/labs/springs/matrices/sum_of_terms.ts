import type { Matrices } from '../../../solver/matrices.ts';
import type { Triplets } from '../../../solver/module.ts';
import { entryAt, type Pattern, type Place, patternOf } from '../../../views/sparsity/pattern.ts';

export const terms = ['springs', 'masses', 'pins'] as const;
export type Term = (typeof terms)[number];

export type TermPatterns = Record<Term, Pattern>;

export function termPatterns({ terms: parts }: Pick<Matrices, 'terms'>): TermPatterns {
  return { springs: patternOf(parts.springs), masses: patternOf(parts.masses), pins: patternOf(parts.pins) };
}

/** N/m: what a term holds at a place. */
export function termAt(patterns: TermPatterns, term: Term, place: Place): number {
  const at = entryAt(patterns[term], place);
  return at < 0 ? 0 : patterns[term].value[at];
}

/** The chosen terms of Q added up, with only the entries that one of them has; and for each entry, as a set of bits, which of them have it. */
export function sumOfTerms(
  { rows, columns, i, j }: Triplets,
  patterns: TermPatterns,
  chosen: readonly Term[],
): { sum: Triplets; from: Uint8Array } {
  const kept: { at: number; value: number; from: number }[] = [];
  for (let at = 0; at < i.length; at++) {
    const place = { row: i[at], column: j[at] };
    let [value, from] = [0, 0];
    for (const term of chosen) {
      const part = termAt(patterns, term, place);
      value += part;
      if (part !== 0) from |= 1 << terms.indexOf(term);
    }
    if (from !== 0) kept.push({ at, value, from });
  }
  return {
    sum: {
      rows,
      columns,
      i: Int32Array.from(kept, ({ at }) => i[at]),
      j: Int32Array.from(kept, ({ at }) => j[at]),
      value: Float64Array.from(kept, ({ value }) => value),
    },
    from: Uint8Array.from(kept, ({ from }) => from),
  };
}
