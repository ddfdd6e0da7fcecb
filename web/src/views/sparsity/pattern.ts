import type { Triplets } from '../../solver/module.ts';

/** A place in a matrix. */
export interface Place {
  row: number;
  column: number;
}

/** The entries of a sparse matrix row by row, each row by columns; and the same by columns, for looking up and down. */
export interface Pattern {
  rows: number;
  columns: number;
  /** rows + 1: where each row begins in `column`, `value` and `kind`. */
  rowStart: Int32Array;
  /** #entries. */
  column: Int32Array;
  value: Float64Array;
  /** #entries: what an entry is drawn as, an index into the colours of the view. */
  kind: Uint8Array;
  /** columns + 1: where each column begins in `row`. */
  columnStart: Int32Array;
  /** #entries. */
  row: Int32Array;
}

/** Two kinds: 0 for entries below zero, 1 for those above, which are drawn over them from afar: the diagonal of Q stays in sight. */
export const bySign = (_: number, value: number) => (value < 0 ? 0 : 1);

/** `kindOf` is told the number of the triplet. Each (row, column) occurs once. */
export function patternOf(
  { rows, columns, i, j, value }: Triplets,
  kindOf: (triplet: number, value: number) => number = bySign,
): Pattern {
  // Sorted by columns first and then, stably, by rows: two passes of counting.
  const byColumn = countingSort(j, columns, null);
  const byRow = countingSort(i, rows, byColumn.order);
  return {
    rows,
    columns,
    rowStart: byRow.start,
    column: byRow.order.map((at) => j[at]),
    value: Float64Array.from(byRow.order, (at) => value[at]),
    kind: Uint8Array.from(byRow.order, (at) => kindOf(at, value[at])),
    columnStart: byColumn.start,
    row: countingSort(j, columns, byRow.order).order.map((at) => i[at]),
  };
}

/** Where the entries of each key begin, and their numbers in that order; those of one key stay in the order given, or else of their numbers. */
function countingSort(keys: Int32Array, count: number, given: Int32Array | null) {
  const start = new Int32Array(count + 1);
  for (const key of keys) start[key + 1]++;
  for (let key = 0; key < count; key++) start[key + 1] += start[key];
  const next = start.slice();
  const order = new Int32Array(keys.length);
  for (let at = 0; at < keys.length; at++) {
    const number = given ? given[at] : at;
    order[next[keys[number]]++] = number;
  }
  return { start, order };
}

/** Which entry stands at a place; −1 where there is none. */
export function entryAt({ rowStart, column }: Pattern, { row, column: wanted }: Place): number {
  const at = lowerBound(column, wanted, rowStart[row], rowStart[row + 1]);
  return at < rowStart[row + 1] && column[at] === wanted ? at : -1;
}

/** The first index in [from, to) of sorted numbers that is not below `wanted`, or `to`. */
export function lowerBound(sorted: Int32Array, wanted: number, from: number, to: number): number {
  let [low, high] = [from, to];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle] < wanted) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** The entry next to `place` that lies at most `reach` rows and columns away, or null. */
export function nearestEntry(pattern: Pattern, place: Place, reach: number): Place | null {
  let nearest: Place | null = null;
  let least = Number.POSITIVE_INFINITY;
  const last = Math.min(pattern.rows - 1, place.row + reach);
  for (let row = Math.max(0, place.row - reach); row <= last; row++) {
    const end = pattern.rowStart[row + 1];
    let at = lowerBound(pattern.column, place.column - reach, pattern.rowStart[row], end);
    for (; at < end && pattern.column[at] <= place.column + reach; at++) {
      const distance = Math.hypot(row - place.row, pattern.column[at] - place.column);
      if (distance >= least) continue;
      least = distance;
      nearest = { row, column: pattern.column[at] };
    }
  }
  return nearest;
}
