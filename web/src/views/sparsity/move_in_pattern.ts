import { lowerBound, type Pattern, type Place } from './pattern.ts';

/**
 * Where a key leads: arrows to the next entry that is not zero, with `byCell` to the next cell whatever it holds; Home and End to the ends of the
 * row, Page Up and Page Down to the first entry of another row. Null for keys that do not move.
 */
export function moveInPattern(key: string, pattern: Pattern, { row, column }: Place, byCell = false): Place | null {
  const { rows, columns, rowStart, columnStart } = pattern;
  const inRow = (from: number) => pattern.column.subarray(rowStart[from], rowStart[from + 1]);
  const inColumn = pattern.row.subarray(columnStart[column], columnStart[column + 1]);
  switch (key) {
    case 'ArrowLeft':
      return { row, column: byCell ? Math.max(0, column - 1) : before(inRow(row), column) };
    case 'ArrowRight':
      return { row, column: byCell ? Math.min(columns - 1, column + 1) : after(inRow(row), column) };
    case 'ArrowUp':
      return { row: byCell ? Math.max(0, row - 1) : before(inColumn, row), column };
    case 'ArrowDown':
      return { row: byCell ? Math.min(rows - 1, row + 1) : after(inColumn, row), column };
    case 'Home':
      return { row, column: inRow(row)[0] ?? 0 };
    case 'End':
      return { row, column: inRow(row).at(-1) ?? columns - 1 };
    case 'PageUp':
      return firstOf(Math.max(0, row - 1));
    case 'PageDown':
      return firstOf(Math.min(rows - 1, row + 1));
    default:
      return null;
  }

  function firstOf(other: number): Place {
    return { row: other, column: inRow(other)[0] ?? column };
  }
}

function before(sorted: Int32Array, here: number): number {
  return sorted[lowerBound(sorted, here, 0, sorted.length) - 1] ?? here;
}

function after(sorted: Int32Array, here: number): number {
  return sorted[lowerBound(sorted, here + 1, 0, sorted.length)] ?? here;
}
