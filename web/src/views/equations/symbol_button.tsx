import { t } from '../../app/messages/index.ts';
import { cardId } from '../../app/pointing.ts';
import { symbolCommand } from '../../notation/macros.ts';
import type { SymbolId } from '../../notation/symbols.ts';
import { Formula } from './formula.tsx';

/** A symbol for the keyboard and the screen reader: focus opens its card, pressing it goes on to the card's link. */
export function SymbolButton({ id }: { id: SymbolId }) {
  return (
    <button type="button" class="symbol-button" data-sym={id} aria-haspopup="dialog" aria-describedby={cardId}>
      <Formula tex={symbolCommand(id)} /> <span class="visually-hidden">{t(`symbols.name.${id}`)}</span>
    </button>
  );
}
