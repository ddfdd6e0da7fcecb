import { entryAt, lowerBound } from './pattern.ts';
import type { Part } from './tiles.ts';
import { fontOf, type Sparsity } from './types.ts';

/** CSS pixels a cell from which lines are drawn between cells, and zeros written. */
const scaleOfLines = 14;
const scaleOfZeros = 24;
/** CSS pixels. */
const type = { smallest: 11, largest: 15, share: 0.34 };
/** A number has to leave that many CSS pixels of its cell free. */
const aroundNumber = 5;

/** Every entry of a part in its cell, with its value where that fits. */
export function drawCells(c: CanvasRenderingContext2D, { pattern, view, ink, write }: Sparsity, part: Part): void {
  const { scale } = view;
  const rows = touched(part.row, part.rows, pattern.rows);
  const columns = touched(part.column, part.columns, pattern.columns);
  const x = (column: number) => (column - view.column) * scale;
  const y = (row: number) => (row - view.row) * scale;
  if (scale >= scaleOfLines) {
    c.fillStyle = ink.line;
    for (let row = rows.from; row <= rows.to; row++)
      c.fillRect(x(columns.from), y(row) - 0.5, x(columns.to) - x(columns.from), 1);
    for (let column = columns.from; column <= columns.to; column++)
      c.fillRect(x(column) - 0.5, y(rows.from), 1, y(rows.to) - y(rows.from));
  }
  const size = Math.min(type.largest * ink.typeScale, Math.max(type.smallest, type.share * scale));
  c.font = fontOf(size);
  c.textAlign = 'center';
  c.textBaseline = 'middle';
  const put = (text: string, row: number, column: number) =>
    c.fillText(text, x(column) + scale / 2, y(row) + scale / 2 + 1);
  const gap = scale >= scaleOfLines ? 1.5 : 0.5;
  const side = scale - 2 * gap;
  for (let row = rows.from; row < rows.to; row++) {
    const end = pattern.rowStart[row + 1];
    let at = lowerBound(pattern.column, columns.from, pattern.rowStart[row], end);
    for (; at < end && pattern.column[at] < columns.to; at++) {
      const colours = ink.kinds[pattern.kind[at]];
      colours.forEach((colour, band) => {
        c.fillStyle = colour;
        c.fillRect(
          x(pattern.column[at]) + gap + (band * side) / colours.length,
          y(row) + gap,
          side / colours.length,
          side,
        );
      });
      if (size > scale - aroundNumber) continue;
      const text = write(pattern.value[at]);
      if (widthOf(c, text) > scale - aroundNumber) continue;
      c.fillStyle = ink.background;
      put(text, row, pattern.column[at]);
    }
  }
  if (scale < scaleOfZeros) return;
  c.fillStyle = ink.muted;
  for (let row = rows.from; row < rows.to; row++)
    for (let column = columns.from; column < columns.to; column++)
      if (entryAt(pattern, { row, column }) < 0) put('0', row, column);
}

/** CSS pixels of texts in the fonts used so far. */
const widths = new Map<string, number>();

function widthOf(c: CanvasRenderingContext2D, text: string): number {
  const key = `${c.font} ${text}`;
  const known = widths.get(key);
  if (known !== undefined) return known;
  const { width } = c.measureText(text);
  if (widths.size > 1e4) widths.clear();
  widths.set(key, width);
  return width;
}

/** The whole cells that a stretch touches. */
function touched(from: number, length: number, cells: number): { from: number; to: number } {
  return { from: Math.max(0, Math.floor(from)), to: Math.min(cells, Math.ceil(from + length)) };
}
