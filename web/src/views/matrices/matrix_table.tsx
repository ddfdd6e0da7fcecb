import type { ComponentChildren } from 'preact';
import { useRef, useState } from 'preact/hooks';
import type { Figure } from '../../app/figure.ts';
import { t } from '../../app/messages/index.ts';
import { cardId } from '../../app/pointing.ts';
import { entryFormat } from '../../lib/entry_format.ts';
import { type Cell, moveInGrid } from '../../lib/move_in_grid.ts';
import { type SymbolId, symbol } from '../../notation/symbols.ts';
import { type MatrixCell, matrixCells } from './matrix_cells.ts';
import './matrices.css';

export interface Matrix {
  symbol: SymbolId;
  /** Row-major, of the symbol's shape in the figure, in the symbol's unit. */
  values: ArrayLike<number>;
  /** The symbol as the page's formulas write it. */
  name: ComponentChildren;
}

interface Props extends Matrix {
  figure: Figure;
  /** Rows that take part in what is pointed at elsewhere. */
  marked?: readonly number[];
}

/** A small matrix with its numbers: rows, columns and entries are linked with the figure's springs and vertices. One tab stop, arrows move inside. */
export function MatrixTable({ figure, symbol: id, values, name, marked = [] }: Props) {
  const table = useRef<HTMLTableElement>(null);
  const [chosen, choose] = useState<Cell>({ row: 1, column: 1 });
  const { unit, write } = entryFormat(values, symbol(id).unit);
  const [heads, ...rows] = matrixCells(id, values, write, figure);
  const stop = { row: Math.min(chosen.row, rows.length), column: Math.min(chosen.column, heads.length - 1) };

  const onKeyDown = (event: KeyboardEvent) => {
    const cell = (event.target as Element).closest('td, th') as HTMLTableCellElement | null;
    if (!cell) return;
    const lines = Array.from((table.current as HTMLTableElement).rows, (line) => Array.from(line.cells));
    const row = lines.findIndex((line) => line.includes(cell));
    const next = moveInGrid(
      event.key,
      { row, column: cell.cellIndex },
      lines.map((line) => line.length),
    );
    if (!next) return;
    event.preventDefault();
    event.stopPropagation(); // here arrows move the focus, not the cursor in time
    const button = lines[next.row][next.column].querySelector('button');
    if (!button) return; // the corner
    choose(next);
    button.focus();
  };

  const row = (cells: MatrixCell[], at: number) =>
    cells.map((cell, column) => (
      <TableCell key={column} cell={cell} symbol={id} isTabStop={at === stop.row && column === stop.column} />
    ));

  return (
    <div class="matrix">
      <table ref={table} onKeyDown={onKeyDown}>
        <caption>
          {name} <span>{captionOf(id, unit)}</span>
        </caption>
        <thead>
          <tr>{row(heads, 0)}</tr>
        </thead>
        <tbody>
          {rows.map((cells, i) => (
            <tr key={i} class={marked.includes(i) ? 'marked' : ''}>
              {row(cells, i + 1)}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function TableCell({ cell, symbol: id, isTabStop }: { cell: MatrixCell; symbol: SymbolId; isTabStop: boolean }) {
  const { kind, text, label, things, place, isLit } = cell;
  if (text === '') return <td />;
  const attributes = {
    class: isLit ? 'lit' : '',
    'data-about': id,
    'data-spring': things.spring,
    'data-vertex': things.vertex,
    'data-row': place.row,
    'data-column': place.column,
    'data-value': place.value,
  };
  const button = (
    <button
      type="button"
      tabIndex={isTabStop ? 0 : -1}
      aria-label={label}
      aria-haspopup="dialog"
      aria-describedby={cardId}
    >
      {text}
    </button>
  );
  if (kind === 'row' || kind === 'column')
    return (
      <th scope={kind === 'row' ? 'row' : 'col'} {...attributes}>
        {button}
      </th>
    );
  return (
    <td {...attributes} data-zero={text === '0'}>
      {button}
    </td>
  );
}

/** What rows and columns stand for, and the unit: "springs × x, y, z, in mm". */
function captionOf(id: SymbolId, unit: string | null): string {
  const axes = symbol(id)
    .shape.map((axis) => t(`matrices.along.${axis}`))
    .join(' × ');
  return unit === null ? axes : t('matrices.inUnit', { axes, unit });
}
