import { gridCorners, gridTriangles } from './grid.ts';
import type { MadeScene, Point, Spring } from './made_scene.ts';

const cells = 10;
const spacing = 0.2; // m

/** From a vertex, in columns and rows: along the threads, across the cells, and over one vertex, which resists bending. */
const reaches = [
  [1, 0],
  [0, 1],
  [1, 1],
  [1, -1],
  [2, 0],
  [0, 2],
];

/** The cloth of a well-known lab on implicit integration, with its numbers: level at first, held by two corners of one edge, so that it swings down. */
export function cloth(): MadeScene {
  const at = (column: number, row: number) => column * (cells + 1) + row;
  const inside = (...places: number[]) => places.every((place) => place >= 0 && place <= cells);
  const springs = reaches.flatMap(([right, up]) =>
    gridCorners(cells, cells, (column, row): Spring[] =>
      inside(column + right, row + up) ? [[at(column, row), at(column + right, row + up)]] : [],
    ).flat(),
  );
  return {
    name: 'cloth',
    // its far edge first: rows come towards the reader
    vertices: gridCorners(
      cells,
      cells,
      (column, row): Point => [spacing * (column - cells / 2), 0, spacing * (row - cells / 2)],
    ),
    // the edges of the triangles are springs of the cloth already, so that the surface adds none
    shape: { springs, triangles: gridTriangles(cells, cells, at) },
    pinned: [at(0, 0), at(cells, 0)],
    k: 100,
    m: 1,
    delta_t: 1 / 60, // a frame of the lab's program
    gravity: 0.3,
    damping: 0.2,
  };
}
