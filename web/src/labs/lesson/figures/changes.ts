import type { SymbolId } from '../../../notation/symbols.ts';

/** What some symbols are at a moment. */
export type Numbers = Partial<Record<SymbolId, Float64Array>>;

/** The symbols of `after` of which any number is not as it was. */
export function changesBetween(before: Numbers, after: Numbers): Set<SymbolId> {
  const ids = Object.keys(after) as SymbolId[];
  return new Set(
    ids.filter((id) => {
      const [old, now] = [before[id], after[id]];
      return !old || !now || old.length !== now.length || old.some((value, at) => value !== now[at]);
    }),
  );
}
