export interface Cell {
  row: number;
  column: number;
}

/** Where a key leads from a cell, among rows of the given lengths. Null for keys that do not move. */
export function moveInGrid(key: string, { row, column }: Cell, lengths: readonly number[]): Cell | null {
  const to = (nextRow: number, nextColumn: number): Cell => {
    const inside = clamp(nextRow, lengths.length);
    return { row: inside, column: clamp(nextColumn, lengths[inside]) };
  };
  switch (key) {
    case 'ArrowUp':
      return to(row - 1, column);
    case 'ArrowDown':
      return to(row + 1, column);
    case 'ArrowLeft':
      return to(row, column - 1);
    case 'ArrowRight':
      return to(row, column + 1);
    case 'Home':
      return to(row, 0);
    case 'End':
      return to(row, lengths[row] - 1);
    default:
      return null;
  }
}

function clamp(index: number, count: number): number {
  return Math.min(Math.max(0, index), count - 1);
}
