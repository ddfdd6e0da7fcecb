import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { decadesAround, decadeTicks } from '../../../../web/src/views/plots/log_axis.ts';

const positive = fc.double({ min: 1e-300, max: 1e300, noNaN: true });

describe('decadesAround', () => {
  it('spans all heights with at least one decade', () => {
    fc.assert(
      fc.property(positive, positive, (a, b) => {
        const [lowest, highest] = decadesAround(Math.min(a, b), Math.max(a, b));
        // 1e-12: a power of ten computed by 10 ** n may be off by a few units in the last place
        expect(lowest).toBeLessThanOrEqual(Math.min(a, b) * (1 + 1e-12));
        expect(highest).toBeGreaterThanOrEqual(Math.max(a, b) * (1 - 1e-12));
        expect(highest / lowest).toBeGreaterThan(9.999);
      }),
    );
  });

  it('is a finite range without data', () => expect(decadesAround(null, null)).toEqual([1e-3, 1]));
});

describe('decadeTicks', () => {
  it.each([
    [1e-5, 1, 6, [-5, -4, -3, -2, -1, 0]],
    [1e-5, 1, 5.9, [-5, -3, -1]],
    [1e-12, 1, 5, [-12, -9, -6, -3, 0]],
    [10, 100, 8, [1, 2]],
  ])('from %d to %d, at most %d', (lowest, highest, most, exponents) => {
    expect(decadeTicks(lowest, highest, most)).toEqual(exponents);
  });
});
