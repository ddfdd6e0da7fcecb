import type { Figure } from '../../app/figure.ts';
import { type Head, headsOf, isLit, thingsOf } from '../../app/heads.ts';
import { litThings, type MatrixPlace } from '../../app/highlight.ts';
import { t } from '../../app/messages/index.ts';
import type { Selection } from '../../app/state.ts';
import { type SymbolId, symbol } from '../../notation/symbols.ts';
import { entryThings } from './entry_things.ts';

export interface MatrixCell {
  kind: 'corner' | 'column' | 'row' | 'entry';
  /** As written. Empty in the corner and over the one column of a vector, where there is nothing to point at. */
  text: string;
  /** As read out. */
  label: string;
  /** What of the figure it belongs to. */
  things: Selection;
  /** Where in the matrix. */
  place: MatrixPlace;
  isLit: boolean;
}

const nowhere: MatrixPlace = { row: null, column: null, value: null };

/** A matrix (row-major) with its heads: first the row of column heads, then for each row its head and its entries. */
export function matrixCells(
  id: SymbolId,
  values: ArrayLike<number>,
  write: (value: number) => string,
  figure: Figure,
): MatrixCell[][] {
  const { rows, columns } = headsOf(id, figure);
  const { code } = symbol(id);
  const { E } = figure.scene.value;
  const lit = litThings(figure);
  const corner: MatrixCell = {
    kind: 'corner',
    text: '',
    label: '',
    things: { spring: null, vertex: null },
    place: nowhere,
    isLit: false,
  };
  const head = (kind: 'row' | 'column', of: Head, at: number): MatrixCell => {
    const things = thingsOf(of);
    return {
      kind,
      text: of.short,
      label: of.name,
      things,
      place: { ...nowhere, [kind]: at },
      isLit: isLit(things, lit),
    };
  };
  const entry = (i: number, j: number): MatrixCell => {
    const [row, column] = [rows[i], columns[j]];
    const value = values[i * columns.length + j];
    const things = entryThings(row, column, value, E);
    const text = write(value);
    return {
      kind: 'entry',
      text,
      label: column.name
        ? t('matrices.entry', { code, row: row.name, column: column.name, value: text })
        : t('matrices.component', { code, row: row.name, value: text }),
      things,
      place: { row: i, column: j, value },
      isLit: [things, thingsOf(row), thingsOf(column)].some((part) => isLit(part, lit)),
    };
  };

  return [
    [corner, ...columns.map((column, j) => head('column', column, j))],
    ...rows.map((row, i) => [head('row', row, i), ...columns.map((_, j) => entry(i, j))]),
  ];
}
