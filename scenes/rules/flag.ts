import { flagPicture } from './flag_picture.ts';
import { gridCorners, gridTriangles } from './grid.ts';
import type { MadeScene, Point } from './made_scene.ts';

const columns = 80;
const rows = 40;
const cell = 0.0225; // m: 1.8 m by 0.9 m
const ripple = 0.08; // m: without it a falling flag would stay in its plane and never fold
const waves = 1.5;

/** A flag held along its left edge. */
export function flag(): MadeScene {
  const at = (column: number, row: number) => column * (rows + 1) + row;
  const triangles = gridTriangles(columns, rows, at);
  return {
    name: 'flag',
    vertices: gridCorners(columns, rows, rippled),
    shape: {
      triangles,
      textureVertices: gridCorners(columns, rows, (column, row) => [column / columns, row / rows]),
      textureTriangles: triangles,
      picture: flagPicture(),
    },
    pinned: Array.from({ length: rows + 1 }, (_, row) => at(0, row)),
    k: 1000, // much stiffer, and 50 iterations a step let it sink as if through honey
  };
}

function rippled(column: number, row: number): Point {
  const along = column / columns; // 0 at the pole, 1 at the fly
  const z = ripple * along * Math.sin(2 * Math.PI * waves * along);
  return [cell * (column - columns / 2), cell * (row - rows / 2), z];
}
