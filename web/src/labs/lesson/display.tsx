import { Formula } from '../../views/equations/formula.tsx';
import { SymbolLegend } from '../../views/equations/symbol_legend.tsx';
import { symbolsIn } from '../../views/equations/symbols_in.ts';

/** A formula on lines of its own, with a button for each of its symbols: the formula itself is out of the keyboard's reach. */
export function Display({ tex }: { tex: string }) {
  const ids = symbolsIn([tex]);
  return (
    <div class="display">
      <Formula tex={tex} display />
      {ids.length > 0 && <SymbolLegend ids={ids} />}
    </div>
  );
}
