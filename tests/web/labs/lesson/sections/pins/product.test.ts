import { expect, it } from 'vitest';
import { product, transposed } from '../../../../../../web/src/labs/lesson/sections/pins/product.ts';

/** Picks vertex 1 of three. */
const C = { rows: 1, columns: 3, values: new Float64Array([0, 1, 0]) };
const p = { rows: 3, columns: 2, values: new Float64Array([1, 2, 3, 4, 5, 6]) };

it('picks a row with C, and puts it back with Cᵀ', () => {
  expect(product(C, p)).toEqual({ rows: 1, columns: 2, values: new Float64Array([3, 4]) });
  const list = { rows: 1, columns: 2, values: new Float64Array([3, 4]) };
  expect(product(transposed(C), list)).toEqual({ rows: 3, columns: 2, values: new Float64Array([0, 0, 3, 4, 0, 0]) });
});

it('multiplies nothing whose shapes do not fit', () => {
  expect(product(transposed(C), p)).toBeNull();
});

it('transposes rows into columns', () => {
  const flipped = { rows: 2, columns: 3, values: new Float64Array([1, 3, 5, 2, 4, 6]) };
  expect(transposed(p)).toEqual(flipped);
});
