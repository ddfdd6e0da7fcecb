import { gridCorners, gridTriangles } from './grid.ts';
import type { MadeScene, Point } from './made_scene.ts';
import { wovenPicture } from './woven_picture.ts';

const columns = 200; // even, so that the alternating diagonals meet at the seam
const rows = 48;

const waist = 0.12; // m, radius
const hem = 0.34; // m, mean radius
const length = 0.5; // m, from waist to hem
const pleats = 9;
const pleatDepth = 0.025; // m, at the hem: without it a falling cone would stay round and never fold

/** A pleated cone of cloth, held all around its waist. Column by column around the body, row by row from the hem up. */
export function skirt(): MadeScene {
  const at = (column: number, row: number) => (column % columns) * (rows + 1) + row;
  const atTexture = (column: number, row: number) => column * (rows + 1) + row;
  return {
    name: 'skirt',
    vertices: gridCorners(columns - 1, rows, pleatedCone),
    shape: {
      triangles: gridTriangles(columns, rows, at),
      textureVertices: gridCorners(columns, rows, (column, row) => [column / columns, row / rows]),
      textureTriangles: gridTriangles(columns, rows, atTexture),
      picture: wovenPicture(),
    },
    pinned: Array.from({ length: columns }, (_, column) => at(column, rows)),
    k: 100, // much stiffer, and 20 iterations a step let it sink as if through honey
    iterations: 20, // the largest scene stays fluid
  };
}

function pleatedCone(column: number, row: number): Point {
  const angle = (2 * Math.PI * column) / columns;
  const fall = 1 - row / rows; // 0 at the waist, 1 at the hem
  const radius = waist + (hem - waist) * fall + pleatDepth * fall * Math.cos(pleats * angle);
  return [radius * Math.sin(angle), length * (0.5 - fall), radius * Math.cos(angle)];
}
