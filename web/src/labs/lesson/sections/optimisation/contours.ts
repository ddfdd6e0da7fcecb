/** Values at the corners of a grid, row by row. */
export interface Grid {
  columns: number;
  rows: number;
  values: Float64Array;
}

/** Ends of a line across a cell, in columns and rows. */
export type Segment = readonly [from: readonly [number, number], to: readonly [number, number]];

/** Where the values, linear along the sides of every cell, pass a level. */
export function contour({ columns, rows, values }: Grid, level: number): Segment[] {
  const segments: Segment[] = [];
  for (let row = 0; row + 1 < rows; row++) {
    for (let column = 0; column + 1 < columns; column++) {
      const corners = [
        [column, row],
        [column + 1, row],
        [column + 1, row + 1],
        [column, row + 1],
      ] as const;
      const crossings = corners.flatMap(([x0, y0], side) => {
        const [x1, y1] = corners[(side + 1) % 4];
        const [a, b] = [values[y0 * columns + x0], values[y1 * columns + x1]];
        if (a < level === b < level) return [];
        const share = (level - a) / (b - a);
        return [[x0 + share * (x1 - x0), y0 + share * (y1 - y0)] as const];
      });
      for (let at = 0; at < crossings.length; at += 2) segments.push([crossings[at], crossings[at + 1]]);
    }
  }
  return segments;
}

/** So many levels from the least to the greatest value; of a power above 1, the closer together the lower they are. */
export function levels(values: Float64Array, count: number, power: number): number[] {
  const least = values.reduce((a, b) => Math.min(a, b));
  const greatest = values.reduce((a, b) => Math.max(a, b));
  return Array.from({ length: count }, (_, at) => least + (greatest - least) * ((at + 1) / (count + 1)) ** power);
}
