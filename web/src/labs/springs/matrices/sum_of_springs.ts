import type { Triplets } from '../../../solver/module.ts';
import { lowerBound } from '../../../views/sparsity/pattern.ts';

/** #E×36: where the share of each spring stands among the triplets of a matrix, row by row: rows i and j by columns i and j, x, y and z of each. */
export function placesOfSprings({ columns, i, j }: Triplets, E: Int32Array): Int32Array {
  const columnStart = new Int32Array(columns + 1);
  for (const column of j) columnStart[column + 1]++;
  for (let column = 0; column < columns; column++) columnStart[column + 1] += columnStart[column];
  const places = new Int32Array(18 * E.length);
  for (let at = 0; at < places.length; at++) {
    const e = Math.floor(at / 36);
    const row = coordinateOf(E, e, Math.floor((at % 36) / 6));
    const column = coordinateOf(E, e, at % 6);
    places[at] = lowerBound(i, row, columnStart[column], columnStart[column + 1]);
  }
  return places;
}

/** Of the six coordinates of a spring's ends: its row in the matrix. */
function coordinateOf(E: Int32Array, e: number, at: number): number {
  return 3 * E[2 * e + Math.floor(at / 3)] + (at % 3);
}

interface Summands {
  /** Its pattern, column by column, rows ascending: that of the sum of all springs. */
  matrix: Triplets;
  /** #E×36: see placesOfSprings. */
  places: Int32Array;
  /** #E×9: what each spring adds at (i, i) and (j, j), and takes away at (i, j) and (j, i). */
  blocks: Float64Array;
  /** What stands on the diagonal before any spring, 3#V; null for nothing. */
  diagonal: Float64Array | null;
}

export interface SumOfSprings {
  sum: Triplets;
  /** #entries: 1 where the last spring added something. */
  latest: Uint8Array;
}

/** The matrix once so many springs are added, with only the entries that are there by then, which may be 0. */
export function sumOfSprings({ matrix, places, blocks, diagonal }: Summands, count: number): SumOfSprings {
  const { rows, columns, i, j } = matrix;
  const value = Float64Array.from(i, (row, at) => (diagonal !== null && row === j[at] ? diagonal[row] : 0));
  const addedBy = new Int32Array(i.length).fill(-1); // the last spring; −1 for none
  for (let at = 0; at < 36 * count; at++) {
    const e = Math.floor(at / 36);
    const [row, column] = [Math.floor((at % 36) / 6), at % 6];
    const sign = row < 3 === column < 3 ? 1 : -1;
    value[places[at]] += sign * blocks[9 * e + 3 * (row % 3) + (column % 3)];
    addedBy[places[at]] = e;
  }
  const there = (_: unknown, at: number) => addedBy[at] >= 0 || (diagonal !== null && i[at] === j[at]);
  return {
    sum: { rows, columns, i: i.filter(there), j: j.filter(there), value: value.filter(there) },
    latest: Uint8Array.from(addedBy, (e) => (count > 0 && e === count - 1 ? 1 : 0)).filter(there),
  };
}

/** Only rows and columns of these vertices, three for each, in this order: P̂ (…) P̂ᵀ. */
export function constrainedTo(free: Int32Array, { sum, latest }: SumOfSprings): SumOfSprings {
  const place = new Int32Array(sum.rows).fill(-1);
  free.forEach((vertex, at) => {
    for (let c = 0; c < 3; c++) place[3 * vertex + c] = 3 * at + c;
  });
  const stays = (_: unknown, at: number) => place[sum.i[at]] >= 0 && place[sum.j[at]] >= 0;
  return {
    sum: {
      rows: 3 * free.length,
      columns: 3 * free.length,
      i: sum.i.filter(stays).map((row) => place[row]),
      j: sum.j.filter(stays).map((column) => place[column]),
      value: sum.value.filter(stays),
    },
    latest: latest.filter(stays),
  };
}
