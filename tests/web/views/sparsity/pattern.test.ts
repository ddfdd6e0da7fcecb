import fc from 'fast-check';
import { expect, it } from 'vitest';
import { entryAt, nearestEntry, patternOf } from '../../../../web/src/views/sparsity/pattern.ts';
import { triplets } from './random_triplets.ts';

it('holds every triplet, with its value and kind, and nothing else', () => {
  fc.assert(
    fc.property(triplets, (matrix) => {
      const pattern = patternOf(matrix, (triplet) => triplet % 3);
      expect(pattern.value).toHaveLength(matrix.value.length);
      matrix.value.forEach((value, triplet) => {
        const at = entryAt(pattern, { row: matrix.i[triplet], column: matrix.j[triplet] });
        expect([pattern.value[at], pattern.kind[at]]).toEqual([value, triplet % 3]);
      });
    }),
  );
});

it('has rows sorted by columns, and columns by rows', () => {
  fc.assert(
    fc.property(triplets, (matrix) => {
      const pattern = patternOf(matrix);
      for (const [start, sorted] of [
        [pattern.rowStart, pattern.column],
        [pattern.columnStart, pattern.row],
      ])
        for (let line = 0; line + 1 < start.length; line++)
          for (let at = start[line] + 1; at < start[line + 1]; at++) expect(sorted[at]).toBeGreaterThan(sorted[at - 1]);
      expect(pattern.columnStart.at(-1)).toBe(matrix.value.length);
    }),
  );
});

it('tells where there is no entry', () => {
  const pattern = patternOf({
    rows: 2,
    columns: 3,
    i: Int32Array.of(1),
    j: Int32Array.of(2),
    value: Float64Array.of(-1),
  });
  expect(entryAt(pattern, { row: 1, column: 2 })).toBe(0);
  expect(entryAt(pattern, { row: 0, column: 2 })).toBe(-1);
  expect(entryAt(pattern, { row: 1, column: 1 })).toBe(-1);
});

it('finds the entry that is nearest, if one is near', () => {
  fc.assert(
    fc.property(triplets, fc.nat(39), fc.nat(39), fc.nat(8), (matrix, row, column, reach) => {
      const place = { row: row % matrix.rows, column: column % matrix.columns };
      const distances = Array.from(matrix.i, (i, at) => {
        const [down, across] = [Math.abs(i - place.row), Math.abs(matrix.j[at] - place.column)];
        return Math.max(down, across) <= reach ? Math.hypot(down, across) : Number.POSITIVE_INFINITY;
      });
      const least = Math.min(Number.POSITIVE_INFINITY, ...distances);
      const found = nearestEntry(patternOf(matrix), place, reach);
      const distance = found && Math.hypot(found.row - place.row, found.column - place.column);
      expect(distance ?? Number.POSITIVE_INFINITY).toBe(least);
    }),
  );
});
