import fc from 'fast-check';
import { expect, it } from 'vitest';
import { patternOf } from '../../../../web/src/views/sparsity/pattern.ts';
import { density, tileSize, tilesOf } from '../../../../web/src/views/sparsity/tiles.ts';
import { triplets } from './random_triplets.ts';

const powerOfTwo = fc.integer({ min: 0, max: 6 }).map((exponent) => 2 ** exponent);
const whole = ({ rows, columns }: { rows: number; columns: number }) => ({ row: 0, column: 0, rows, columns });

it('of the whole matrix count every entry once', () => {
  fc.assert(
    fc.property(triplets, powerOfTwo, (matrix, size) => {
      const { count } = tilesOf(patternOf(matrix), size, whole(matrix));
      expect(count.reduce((sum, entries) => sum + entries, 0)).toBe(matrix.value.length);
    }),
  );
});

it('of a part are those of the whole: tiles do not move with what is shown', () => {
  fc.assert(
    fc.property(triplets, powerOfTwo, fc.double({ min: -5, max: 39, noNaN: true }), (matrix, size, from) => {
      const pattern = patternOf(matrix);
      const all = tilesOf(pattern, size, whole(matrix));
      const part = tilesOf(pattern, size, { row: from, column: from / 2, rows: 7.5, columns: 12 });
      for (let row = 0; row < part.rows; row++)
        for (let column = 0; column < part.columns; column++) {
          const inAll = (part.firstRow + row) * all.columns + part.firstColumn + column;
          const inPart = row * part.columns + column;
          expect([part.count[inPart], part.kind[inPart]]).toEqual([all.count[inAll], all.kind[inAll]]);
        }
    }),
  );
});

it('are the cells themselves where a cell is a pixel', () => {
  expect(tileSize(1)).toBe(1);
  expect(tileSize(40)).toBe(1);
  const matrix = { rows: 2, columns: 2, i: Int32Array.of(1), j: Int32Array.of(0), value: Float64Array.of(3) };
  expect([...tilesOf(patternOf(matrix), 1, whole(matrix)).count]).toEqual([0, 0, 1, 0]);
});

it('are at least a pixel wide, and less than two', () => {
  fc.assert(
    fc.property(fc.double({ min: 1e-4, max: 1, maxExcluded: true, noNaN: true }), (pixelsPerCell) => {
      const pixels = tileSize(pixelsPerCell) * pixelsPerCell;
      expect(pixels).toBeGreaterThanOrEqual(1);
      expect(pixels).toBeLessThan(2);
    }),
  );
});

it('are darker with more entries: empty white, full black, one among many in sight', () => {
  expect(density(0, 64)).toBe(0);
  expect(density(64 * 64, 64)).toBe(1);
  expect(density(1, 64)).toBeGreaterThan(0.35);
  expect(density(100, 64)).toBeGreaterThan(density(10, 64));
});
