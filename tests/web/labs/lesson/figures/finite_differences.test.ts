import { expect, it } from 'vitest';
import { centralDifferences, pointsAround } from '../../../../../web/src/labs/lesson/figures/finite_differences.ts';

it('central differences of a quadratic are its gradient', () => {
  const p = Float64Array.of(9, 9, 9, 0.5, -0.25, 0);
  // ∂/∂x = 6x + y, ∂/∂y = x − 4y at vertex 1
  const energy = ([, , , x, y]: Float64Array) => 3 * x * x + x * y - 2 * y * y;
  const [byX, byY] = centralDifferences(pointsAround(p, 1).map(energy));
  // exact for quadratics but for rounding: 1e-16 of 1 J over 2e-5 m
  expect(byX).toBeCloseTo(2.75, 9);
  expect(byY).toBeCloseTo(1.5, 9);
});
