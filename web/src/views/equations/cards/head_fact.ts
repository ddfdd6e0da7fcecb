import type { MatrixPlace } from '../../../app/highlight.ts';
import { t } from '../../../app/messages/index.ts';
import { type SymbolId, symbol } from '../../../notation/symbols.ts';
import type { Fact } from './facts.tsx';

/** The row or column of a matrix that a spring or vertex was pointed at in. */
export interface MatrixHead {
  id: SymbolId;
  place: MatrixPlace;
}

export function headFact({ id, place: { row, column } }: MatrixHead): Fact {
  const { code } = symbol(id);
  const where = row === null ? t('equations.card.inColumn', { column }) : t('equations.card.inRow', { row });
  return [t('equations.card.in', { code }), where];
}
