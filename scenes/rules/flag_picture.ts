import { ivory, type Picture, paint, sand, slate, vermilion } from './picture.ts';

const columns = 8;
const rows = 4;
const tile = 96; // pixels
const samples = 3;

/** A net of overlapping circles, whose common parts are leaves, around one disc. */
export function flagPicture(): Picture {
  return paint(columns * tile, rows * tile, samples, (x, y) => {
    if (Math.hypot(x / tile - 3, y / tile - 2) < 1) return vermilion;
    const column = Math.floor(x / tile);
    const row = Math.floor(y / tile);
    const aroundDisc = (column === 2 || column === 3) && (row === 1 || row === 2);
    const even = (column + row) % 2 === 0;
    if (!aroundDisc && inLeaf(even ? x / tile - column : 1 - (x / tile - column), y / tile - row)) return slate;
    return even || aroundDisc ? ivory : sand;
  });
}

/** Whether a point of the unit square lies within 1 of both ends of its falling diagonal. */
function inLeaf(x: number, y: number): boolean {
  return Math.hypot(x, y) < 1 && Math.hypot(1 - x, 1 - y) < 1;
}
