import type { SymbolId } from '../../../notation/symbols.ts';
import type { Frame } from '../../../solver/frame.ts';

/** #V×3 positions, m: an arrow at every vertex. */
export interface Arrows {
  from: Float64Array;
  to: Float64Array;
  /** What they stand for. */
  symbol: SymbolId;
}

/** What the half-step at the cursor moved. */
export function moves({ pBefore, p }: Frame): Arrows {
  return { from: pBefore, to: p, symbol: 'p' };
}
