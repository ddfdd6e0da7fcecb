import { t } from '../../app/messages/index.ts';
import { SymbolButton } from './symbol_button.tsx';
import { symbolsIn } from './symbols_in.ts';

/** One button for each symbol of the formulas: what the mouse finds in the formula, keyboard and screen reader find here. */
export function SymbolLegend({ formulas }: { formulas: readonly string[] }) {
  const ids = symbolsIn(formulas);
  if (ids.length === 0) return null;
  return (
    <ul class="symbol-legend" aria-label={t('equations.legend')}>
      {ids.map((id) => (
        <li key={id}>
          <SymbolButton id={id} />
        </li>
      ))}
    </ul>
  );
}
