import type { Pattern, Place } from './pattern.ts';

/** Which part of a matrix is shown: CSS pixels a cell, and what stands in the top left corner, in cells, fractions included. */
export interface Viewport {
  scale: number;
  row: number;
  column: number;
}

/** CSS pixels. */
export interface Area {
  width: number;
  height: number;
}

export type Size = Pick<Pattern, 'rows' | 'columns'>;

/** CSS pixels a cell: wide enough for any number. */
const largestScale = 88;
/** No matrix is so small that its cells have to fill the screen. */
const largestFit = 56;

/** CSS pixels a cell at which all of the matrix is seen. */
export function fitScale({ rows, columns }: Size, { width, height }: Area): number {
  return Math.min(largestFit, width / Math.max(1, columns), height / Math.max(1, rows));
}

export function fitted(size: Size, area: Area): Viewport {
  return inside({ scale: fitScale(size, area), row: 0, column: 0 }, size, area);
}

/** Nearer by a factor over 1; what is at (x, y), CSS pixels, stays there as long as the matrix fills the area. */
export function zoomedAt(view: Viewport, factor: number, x: number, y: number, size: Size, area: Area): Viewport {
  const least = fitScale(size, area);
  const scale = Math.min(Math.max(largestScale, least), Math.max(least, view.scale * factor));
  return inside(
    { scale, row: view.row + y / view.scale - y / scale, column: view.column + x / view.scale - x / scale },
    size,
    area,
  );
}

/** Moved with the pointer by so many CSS pixels. */
export function panned(view: Viewport, dx: number, dy: number, size: Size, area: Area): Viewport {
  return inside({ ...view, row: view.row - dy / view.scale, column: view.column - dx / view.scale }, size, area);
}

/** Moved no farther than it takes to see a place whole. */
export function showing(view: Viewport, { row, column }: Place, size: Size, area: Area): Viewport {
  const nearest = (from: number, index: number, shown: number) => Math.max(Math.min(from, index), index + 1 - shown);
  return inside(
    {
      ...view,
      row: nearest(view.row, row, area.height / view.scale),
      column: nearest(view.column, column, area.width / view.scale),
    },
    size,
    area,
  );
}

/** The cell at (x, y), CSS pixels; null beside the matrix. */
export function placeAt(view: Viewport, x: number, y: number, { rows, columns }: Size): Place | null {
  const row = Math.floor(view.row + y / view.scale);
  const column = Math.floor(view.column + x / view.scale);
  return row >= 0 && column >= 0 && row < rows && column < columns ? { row, column } : null;
}

/** Nothing is shown beyond the matrix's edges where it fills the area; where it does not, it stands in the middle. */
function inside(view: Viewport, { rows, columns }: Size, area: Area): Viewport {
  const held = (from: number, count: number, shown: number) =>
    shown >= count ? (count - shown) / 2 : Math.min(count - shown, Math.max(0, from));
  return {
    scale: view.scale,
    row: held(view.row, rows, area.height / view.scale),
    column: held(view.column, columns, area.width / view.scale),
  };
}
