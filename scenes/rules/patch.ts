import { gridCorners } from './grid.ts';
import type { MadeScene, Point, Spring } from './made_scene.ts';

const cells = 2;
const spacing = 0.4; // m

/** Nine vertices and twelve springs, upright, hung by the two upper corners. Rows of vertices as one reads. */
export function patch(): MadeScene {
  const at = (column: number, row: number) => row * (cells + 1) + column;
  const springs: Spring[] = [];
  for (let row = 0; row <= cells; row++) {
    for (let column = 0; column < cells; column++) springs.push([at(column, row), at(column + 1, row)]);
  }
  for (let row = 0; row < cells; row++) {
    for (let column = 0; column <= cells; column++) springs.push([at(column, row), at(column, row + 1)]);
  }
  return {
    name: 'patch',
    // gridCorners goes column by column: its columns are these rows
    vertices: gridCorners(cells, cells, (row, column): Point => [spacing * (column - cells / 2), -spacing * row, 0]),
    shape: { springs },
    pinned: [at(0, 0), at(cells, 0)],
    k: 200,
    m: 0.5,
  };
}
