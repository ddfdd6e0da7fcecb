import type { Frame } from '../../../../solver/frame.ts';
import type { Evaluation } from '../../../../solver/protocol.ts';
import { windows } from '../../figures/planar_scenes.ts';
import type { Grid } from './contours.ts';
import { type Term, termValue } from './terms.ts';

/** The vertex that is free to move: E is drawn over the places where it could be. */
export const free = 1;

const columns = 49;
const rows = 35;
const { left, right, bottom, top } = windows['single-spring-horizontal'];

/** m: the corner of the grid in a column and row, not necessarily whole ones. */
export function cornerAt([column, row]: readonly [number, number]): [number, number, number] {
  return [left + ((right - left) * column) / (columns - 1), bottom + ((top - bottom) * row) / (rows - 1), 0];
}

/** p, and then p with the free vertex at each corner of the grid. Each #V×3, m. */
export function landscapePoints({ p }: Frame): Float64Array[] {
  const corners = Array.from({ length: columns * rows }, (_, at) => {
    const point = p.slice();
    point.set(cornerAt([at % columns, Math.floor(at / columns)]), 3 * free);
    return point;
  });
  return [p, ...corners];
}

/** J: a term of E over the grid, from the evaluations at those points. */
export function landscape(term: Term, [, ...corners]: readonly Evaluation[]): Grid {
  return { columns, rows, values: Float64Array.from(corners, (evaluation) => termValue(term, evaluation)) };
}
