import { describe, expect, it } from 'vitest';
import { linesOf, slopeOf } from '../../../../../web/src/labs/integrators/order/lines.ts';
import type { Errors } from '../../../../../web/src/solver/order_of_accuracy.ts';

const errorsOf = (law: (delta_t: number) => number): Errors => ({
  way: { method: 'newton', iterations: 1 },
  errors: [8, 4, 2, 1, 0.5, 0.25].map((delta_t) => ({ delta_t, error: law(delta_t) })),
});

describe('the slope', () => {
  it('is the exponent of the finest half alone', () => {
    // Logarithms of numbers near 1, divided by their spread of about 1: rounding is some 1e-15.
    expect(slopeOf(errorsOf((delta_t) => (delta_t > 1 ? 100 : 3 * delta_t ** 2)))).toBeCloseTo(2, 13);
  });
});

describe('the lines', () => {
  it('are one for methods whose errors agree at every time step, and run from the finest step on', () => {
    const linear = errorsOf((delta_t) => 3 * delta_t);
    const nearly = errorsOf((delta_t) => 3.001 * delta_t);
    const other = errorsOf((delta_t) => (delta_t === 8 ? 25 : 3 * delta_t));
    const lines = linesOf([linear, other, nearly]);
    expect(lines.map(({ members }) => members)).toEqual([[0, 2], [1]]);
    expect(lines[0].points[0]).toEqual([0.25, 0.75]);
    expect(lines[0].points.at(-1)).toEqual([8, 24]);
  });
});
