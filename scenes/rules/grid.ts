import type { Triangle } from './made_scene.ts';

/**
 * Two triangles for each cell of a grid, counter-clockwise when columns run right and rows run up. The diagonals alternate, so that the cloth is as stiff
 * to the left as to the right. `index` numbers the corners: column 0 … columns, row 0 … rows.
 */
export function gridTriangles(
  columns: number,
  rows: number,
  index: (column: number, row: number) => number,
): Triangle[] {
  const triangles: Triangle[] = [];
  for (let column = 0; column < columns; column++) {
    for (let row = 0; row < rows; row++) {
      const a = index(column, row);
      const b = index(column + 1, row);
      const c = index(column + 1, row + 1);
      const d = index(column, row + 1);
      if ((column + row) % 2 === 0) triangles.push([a, b, c], [a, c, d]);
      else triangles.push([a, b, d], [b, c, d]);
    }
  }
  return triangles;
}

/** `make` at every corner of a grid, column by column. */
export function gridCorners<T>(columns: number, rows: number, make: (column: number, row: number) => T): T[] {
  const corners: T[] = [];
  for (let column = 0; column <= columns; column++) {
    for (let row = 0; row <= rows; row++) corners.push(make(column, row));
  }
  return corners;
}
