import { type Head, thingsOf } from '../../app/heads.ts';
import { springBetween } from '../../app/spring_between.ts';
import type { Selection } from '../../app/state.ts';

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
