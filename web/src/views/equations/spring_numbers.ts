import { norm, row, subtract, type Vector } from '../../lib/vector.ts';
import type { Frame } from '../../solver/frame.ts';

/** Row `index` of E and r: vertices i and j, rest length r in m. */
export interface Spring {
  index: number;
  i: number;
  j: number;
  r: number;
}

/** What the local step does to one spring. Metres. */
export interface SpringNumbers {
  p_i: Vector;
  p_j: Vector;
  /** p_i − p_j and its length. */
  difference: Vector;
  length: number;
  /** (length − r)/r, dimensionless; null for a spring of rest length 0. */
  strain: number | null;
  /** Null at predict, before there is one. */
  d: Vector | null;
}

/** After a local step p is still the one that d was computed from; afterwards p has moved on and pBefore is that one. */
export function springNumbers(frame: Frame, { index, i, j, r }: Spring): SpringNumbers {
  const afterGlobal = frame.phase === 'global' || frame.phase === 'accept';
  const p = afterGlobal ? frame.pBefore : frame.p;
  const p_i = row(p, i);
  const p_j = row(p, j);
  const difference = subtract(p_i, p_j);
  const length = norm(difference);
  return { p_i, p_j, difference, length, strain: r > 0 ? (length - r) / r : null, d: frame.d && row(frame.d, index) };
}
