import { type Axis, type SymbolId, symbol } from '../notation/symbols.ts';
import type { Figure } from './figure.ts';
import { type Head, headAt } from './heads.ts';
import type { MatrixPlace } from './highlight.ts';
import { t } from './messages/index.ts';
import { springBetween } from './spring_between.ts';
import { springsAt } from './thing_facts.ts';

/** An entry of a symbol's matrix: what its row and its column belong to. The one column of a vector belongs to nothing. */
export interface Entry {
  symbol: SymbolId;
  row: Head;
  column: Head | null;
  value: number;
}

export function entryAt(id: SymbolId, { row, column, value }: MatrixPlace, figure: Figure): Entry | null {
  if (row === null || column === null || value === null) return null;
  const [rows, columns] = symbol(id).shape as readonly Axis[];
  return {
    symbol: id,
    row: headAt(rows, row, figure),
    column: columns ? headAt(columns, column, figure) : null,
    value,
  };
}

/** Why an entry is what it is, in words; null where nothing is to be said that its row and column do not say. */
export function entryMeaning({ symbol: id, row, column, value }: Entry, figure: Figure): string | null {
  if (!column) return null;
  const { E } = figure.scene.value;
  const [i, j] = [row.index, column.index];
  switch (id) {
    case 'A':
      if (value === 0) return t('equations.card.entry.apart', { spring: i, vertex: j });
      return t(value > 0 ? 'equations.card.entry.starts' : 'equations.card.entry.ends', { spring: i, vertex: j });
    case 'C':
      return t(value === 0 ? 'equations.card.entry.otherPin' : 'equations.card.entry.pin', { vertex: i, other: j });
    case 'M':
      return t(i === j ? 'equations.card.entry.mass' : 'equations.card.entry.noMass', { vertex: i });
    case 'Q': {
      if (i === j) return t('equations.card.entry.diagonal', { vertex: i, count: springsAt(E, i) });
      const spring = springBetween(E, i, j);
      if (spring === null) return t('equations.card.entry.unjoined', { i, j });
      return value === 0 ? null : t('equations.card.entry.joined', { spring, i, j });
    }
    case 'E':
      return t(j === 0 ? 'equations.card.entry.first' : 'equations.card.entry.second', { spring: i, vertex: value });
    default:
      return null;
  }
}
