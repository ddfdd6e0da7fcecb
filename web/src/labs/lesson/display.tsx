import { SymbolLegend } from '../../views/equations/symbol_legend.tsx';
import { symbolsIn } from '../../views/equations/symbols_in.ts';
import { WideFormula } from './wide_formula.tsx';

/** A formula on lines of its own, with a button for each of its symbols: the formula itself is out of the keyboard's reach. */
export function Display({ tex }: { tex: string }) {
  const ids = symbolsIn([tex]);
  return (
    <div class="display">
      <WideFormula tex={tex} />
      {ids.length > 0 && <SymbolLegend ids={ids} />}
    </div>
  );
}
