import { lowerBound, type Pattern } from './pattern.ts';

/** Square blocks of cells, of a part of a matrix. */
export interface Tiles {
  /** Rows and columns of one, in cells: a power of two. */
  size: number;
  /** Of the first tile, in tiles from the matrix's corner: tiles stay where they are while the part shown moves. */
  firstRow: number;
  firstColumn: number;
  rows: number;
  columns: number;
  /** rows × columns, row-major: how many entries lie in each, */
  count: Uint32Array;
  /** and the largest kind among them: what is drawn over the others. */
  kind: Uint8Array;
}

/** Part of a matrix, in cells, fractions included. */
export interface Part {
  row: number;
  column: number;
  rows: number;
  columns: number;
}

/** How many cells' side a tile needs to be at least one pixel wide. */
export function tileSize(pixelsPerCell: number): number {
  return pixelsPerCell >= 1 ? 1 : 2 ** Math.ceil(-Math.log2(pixelsPerCell));
}

/** The tiles that a part of a matrix touches. Takes a time that grows with the entries in it and with the tiles. */
export function tilesOf(pattern: Pattern, size: number, part: Part): Tiles {
  const [firstRow, rows] = touched(part.row, part.rows, pattern.rows, size);
  const [firstColumn, columns] = touched(part.column, part.columns, pattern.columns, size);
  const count = new Uint32Array(rows * columns);
  const kind = new Uint8Array(rows * columns);
  const shift = Math.log2(size);
  const lastRow = Math.min(pattern.rows, (firstRow + rows) * size);
  const beginColumn = firstColumn * size;
  const endColumn = (firstColumn + columns) * size;
  for (let row = firstRow * size; row < lastRow; row++) {
    const begin = ((row >> shift) - firstRow) * columns - firstColumn;
    const end = pattern.rowStart[row + 1];
    let at = lowerBound(pattern.column, beginColumn, pattern.rowStart[row], end);
    for (; at < end && pattern.column[at] < endColumn; at++) {
      const tile = begin + (pattern.column[at] >> shift);
      count[tile]++;
      if (pattern.kind[at] > kind[tile]) kind[tile] = pattern.kind[at];
    }
  }
  return { size, firstRow, firstColumn, rows, columns, count, kind };
}

/** The first tile that a stretch of cells touches, and how many. */
function touched(from: number, length: number, cells: number, size: number): [first: number, count: number] {
  const first = Math.max(0, Math.floor(from / size));
  const end = Math.min(Math.ceil(cells / size), Math.ceil((from + length) / size));
  return [first, Math.max(0, end - first)];
}

/** 0 … 1: how dark a tile is. A single entry among thousands can still be seen. */
export function density(count: number, size: number): number {
  return count === 0 ? 0 : 0.35 + 0.65 * (Math.log2(1 + count) / Math.log2(1 + size * size));
}
