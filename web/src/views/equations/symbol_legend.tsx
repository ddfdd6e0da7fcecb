import { highlightedSymbol } from '../../app/highlight.ts';
import { t } from '../../app/messages/index.ts';
import { symbolCommand } from '../../notation/macros.ts';
import type { SymbolId } from '../../notation/symbols.ts';
import { Formula } from './formula.tsx';
import { pointedElement } from './pointing.ts';
import { symbolCardId } from './symbol_card.tsx';

/** One button a symbol: what the mouse finds in the formula, keyboard and screen reader find here. */
export function SymbolLegend({ ids }: { ids: readonly SymbolId[] }) {
  const described = pointedElement.value?.closest('.symbol-legend') ? highlightedSymbol.value : null;
  return (
    <ul class="symbol-legend" aria-label={t('equations.legend')}>
      {ids.map((id) => (
        <li key={id}>
          <button type="button" data-sym={id} {...(id === described ? { 'aria-describedby': symbolCardId } : {})}>
            <Formula tex={symbolCommand(id)} /> <span class="visually-hidden">{t(`symbols.name.${id}`)}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}
