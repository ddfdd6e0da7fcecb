import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fitted, panned, placeAt, showing, zoomedAt } from '../../../../web/src/views/sparsity/viewport.ts';

const area = { width: 600, height: 400 };
const size = { rows: 5000, columns: 5000 };
const x = fc.integer({ min: 0, max: area.width - 1 });
const y = fc.integer({ min: 0, max: area.height - 1 });

describe('fitted', () => {
  it('shows all of a matrix, in the middle', () => {
    const view = fitted({ rows: 200, columns: 100 }, area);
    expect(view).toEqual({ scale: 2, row: 0, column: -100 });
  });

  it('does not blow up a small one', () => {
    const view = fitted({ rows: 2, columns: 2 }, area);
    expect(view.scale).toBe(56);
    expect(placeAt(view, 300 - 1, 200 - 1, { rows: 2, columns: 2 })).toEqual({ row: 0, column: 0 });
    expect(placeAt(view, 300 + 1, 200 + 1, { rows: 2, columns: 2 })).toEqual({ row: 1, column: 1 });
    expect(placeAt(view, 300 - 57, 200, { rows: 2, columns: 2 })).toBeNull();
  });
});

describe('zooming', () => {
  it('keeps what is under the pointer there, where the matrix fills the area', () => {
    fc.assert(
      fc.property(x, y, fc.double({ min: 1, max: 3, noNaN: true }), (px, py, factor) => {
        const view = zoomedAt(fitted(size, area), 40, 300, 200, size, area);
        const nearer = zoomedAt(view, factor, px, py, size, area);
        // cells; rounding of numbers up to 5000
        expect(nearer.column + px / nearer.scale).toBeCloseTo(view.column + px / view.scale, 8);
        expect(nearer.row + py / nearer.scale).toBeCloseTo(view.row + py / view.scale, 8);
      }),
    );
  });

  it('goes no farther away than all of the matrix', () => {
    expect(zoomedAt(fitted(size, area), 0.1, 10, 10, size, area)).toEqual(fitted(size, area));
  });
});

it('panning there and back is nothing, as long as the edge is not met', () => {
  const view = zoomedAt(fitted(size, area), 40, 300, 200, size, area);
  const back = panned(panned(view, 30, -20, size, area), -30, 20, size, area);
  expect(back.row).toBeCloseTo(view.row, 9);
  expect(back.column).toBeCloseTo(view.column, 9);
});

it('panning stops at the edges', () => {
  const view = zoomedAt(fitted(size, area), 40, 300, 200, size, area);
  const corner = panned(view, 1e6, 1e6, size, area);
  expect([corner.row, corner.column]).toEqual([0, 0]);
  const other = panned(view, -1e6, -1e6, size, area);
  expect(other.row).toBeCloseTo(5000 - area.height / view.scale, 9);
});

it('whatever is asked for is brought into view whole, and moves nothing when it is there already', () => {
  fc.assert(
    fc.property(fc.nat(4999), fc.nat(4999), (row, column) => {
      const view = zoomedAt(fitted(size, area), 200, 300, 200, size, area);
      const shown = showing(view, { row, column }, size, area);
      // pixels, half a millionth for rounding
      expect((row - shown.row) * shown.scale).toBeGreaterThan(-1e-6);
      expect((row + 1 - shown.row) * shown.scale).toBeLessThan(area.height + 1e-6);
      expect((column - shown.column) * shown.scale).toBeGreaterThan(-1e-6);
      expect((column + 1 - shown.column) * shown.scale).toBeLessThan(area.width + 1e-6);
      expect(showing(shown, { row, column }, size, area)).toEqual(shown);
    }),
  );
});
