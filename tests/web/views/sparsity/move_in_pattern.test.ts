import { expect, it } from 'vitest';
import { moveInPattern } from '../../../../web/src/views/sparsity/move_in_pattern.ts';
import { patternOf } from '../../../../web/src/views/sparsity/pattern.ts';

/**
 *   1 · · 2
 *   · · · ·
 *   3 · 4 ·
 */
const pattern = patternOf({
  rows: 3,
  columns: 4,
  i: Int32Array.of(2, 0, 2, 0),
  j: Int32Array.of(2, 3, 0, 0),
  value: Float64Array.of(4, 2, 3, 1),
});
const from = (row: number, column: number, key: string, byCell = false) => {
  const place = moveInPattern(key, pattern, { row, column }, byCell);
  return place && [place.row, place.column];
};

it('arrows jump over zeros, within a row or column', () => {
  expect(from(0, 0, 'ArrowRight')).toEqual([0, 3]);
  expect(from(0, 3, 'ArrowLeft')).toEqual([0, 0]);
  expect(from(0, 0, 'ArrowDown')).toEqual([2, 0]);
  expect(from(2, 2, 'ArrowUp')).toEqual([2, 2]); // nothing above
  expect(from(0, 3, 'ArrowRight')).toEqual([0, 3]);
  expect(from(1, 2, 'ArrowDown')).toEqual([2, 2]); // also from a zero
});

it('with Shift they go cell by cell', () => {
  expect(from(0, 0, 'ArrowRight', true)).toEqual([0, 1]);
  expect(from(0, 0, 'ArrowUp', true)).toEqual([0, 0]);
  expect(from(2, 3, 'ArrowRight', true)).toEqual([2, 3]);
});

it('Home and End lead to the ends of a row, Page Up and Page Down to other rows', () => {
  expect(from(2, 2, 'Home')).toEqual([2, 0]);
  expect(from(0, 0, 'End')).toEqual([0, 3]);
  expect(from(0, 3, 'PageDown')).toEqual([1, 3]); // an empty row: the column stays
  expect(from(1, 3, 'PageDown')).toEqual([2, 0]);
  expect(from(0, 3, 'PageUp')).toEqual([0, 0]);
});

it('other keys mean nothing', () => {
  expect(from(0, 0, 'x')).toBeNull();
});
