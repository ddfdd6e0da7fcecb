import { t } from '../../app/messages/index.ts';
import type { SymbolId } from '../../notation/symbols.ts';
import { SymbolButton } from './symbol_button.tsx';

/** One button a symbol: what the mouse finds in the formula, keyboard and screen reader find here. */
export function SymbolLegend({ ids }: { ids: readonly SymbolId[] }) {
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
