import type { Selection } from '../../app/state.ts';
import { type Head, thingsOf } from './heads.ts';

/**
 * The spring and vertex that an entry belongs to. In a matrix of vertices by vertices the diagonal belongs to the vertices, and what is not zero
 * off the diagonal to the springs between them. E: #E×2.
 */
export function entryThings(row: Head, column: Head, value: number, E: Int32Array): Selection {
  if (row.thing === 'vertex' && column.thing === 'vertex') {
    if (row.index === column.index) return thingsOf(row);
    return { spring: value === 0 ? null : springBetween(E, row.index, column.index), vertex: null };
  }
  const [ofRow, ofColumn] = [thingsOf(row), thingsOf(column)];
  return { spring: ofRow.spring ?? ofColumn.spring, vertex: ofRow.vertex ?? ofColumn.vertex };
}

function springBetween(E: Int32Array, i: number, j: number): number | null {
  for (let e = 0; e < E.length / 2; e++) {
    const [from, to] = E.subarray(2 * e, 2 * e + 2);
    if ((from === i && to === j) || (from === j && to === i)) return e;
  }
  return null;
}
