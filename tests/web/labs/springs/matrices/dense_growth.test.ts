import { expect, it } from 'vitest';
import {
  extrapolated,
  largest,
  unknownsWithin,
  verticesInMemory,
} from '../../../../../web/src/labs/springs/matrices/dense_growth.ts';

const factorise = { call: 'dense_factorise', n: 1000, milliseconds: 50 } as const;
const substitute = { call: 'dense_substitute', n: 1000, milliseconds: 2 } as const;

it('twice the unknowns take eight times as long to factorise, four times to solve', () => {
  expect(extrapolated(factorise, 2000)).toBe(400);
  expect(extrapolated(substitute, 2000)).toBe(8);
});

it('what fits a budget takes just that', () => {
  // ms; rounding of a cube root
  expect(extrapolated(factorise, unknownsWithin(factorise, 1000))).toBeCloseTo(1000, 9);
  expect(extrapolated(substitute, unknownsWithin(substitute, 16))).toBeCloseTo(16, 9);
});

it('the flag, of 3,321 vertices and 9,760 springs, is about as large as dense memory goes', () => {
  // docs/decisions/0101: it takes about 435 of 450 MB
  expect(verticesInMemory(9760 / 3321)).toBeGreaterThan(3321);
  expect(verticesInMemory(9760 / 3321)).toBeLessThan(3500);
});

it('builds on the largest net', () => {
  const small = { ...factorise, n: 100 };
  expect(largest([small, factorise, substitute], 'dense_factorise')).toEqual(factorise);
  expect(largest([substitute], 'dense_factorise')).toBeNull();
});
