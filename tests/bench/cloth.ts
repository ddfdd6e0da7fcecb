import { gridCorners, gridTriangles } from '../../scenes/rules/grid.ts';
import type { MadeScene, Spring } from '../../scenes/rules/made_scene.ts';

const cell = 0.0225; // m: like the rest that of scenes/rules/flag.ts

/** A sheet of cloth twice as long as wide, held along its left edge: the flag in any size. */
export function cloth(rows: number): MadeScene {
  const columns = 2 * rows;
  const triangles = gridTriangles(columns, rows, (column, row) => column * (rows + 1) + row);
  return {
    name: 'cloth',
    vertices: gridCorners(columns, rows, (column, row) => [cell * column, cell * row, 0]),
    // Those between two triangles twice, which makes them no two springs.
    shape: {
      springs: triangles.flatMap(([a, b, c]): Spring[] => [
        [a, b],
        [b, c],
        [c, a],
      ]),
    },
    pinned: Array.from({ length: rows + 1 }, (_, row) => row),
    k: 1000, // N/m
    m: cell ** 2, // kg, at 1 kg/m²
  };
}
