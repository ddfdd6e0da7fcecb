import { SymbolLegend } from './symbol_legend.tsx';
import { WideFormula } from './wide_formula.tsx';
import './prose.css';

/** A formula on lines of its own, with a button for each of its symbols: the formula itself is out of the keyboard's reach. */
export function Display({ tex }: { tex: string }) {
  return (
    <div class="display">
      <WideFormula tex={tex} />
      <SymbolLegend formulas={[tex]} />
    </div>
  );
}
