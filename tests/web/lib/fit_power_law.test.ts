import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fitPowerLaw } from '../../../web/src/lib/fit_power_law.ts';

const sizes = [25, 100, 400, 1600];

describe('fitPowerLaw', () => {
  it('finds the law that the points obey', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 0, max: 4, noNaN: true }),
        fc.double({ min: 1e-6, max: 10, noNaN: true }),
        (exponent, factor) => {
          const law = fitPowerLaw(sizes.map((n) => [n, factor * n ** exponent]));
          // Logarithms up to 40 are rounded to 1e-14 of themselves and divided by their spread of 4.
          expect(law?.exponent).toBeCloseTo(exponent, 11);
          expect(law && law.factor / factor).toBeCloseTo(1, 10);
        },
      ),
    );
  });

  it('is not misled by errors that cancel: twice as long at one end and at the other', () => {
    const times = sizes.map((n, at) => [n, n * (at === 0 || at === 3 ? 2 : 1)] as const);
    expect(fitPowerLaw(times)?.exponent).toBeCloseTo(1, 12);
  });

  it('wants three points at least', () => {
    expect(fitPowerLaw(sizes.slice(0, 2).map((n) => [n, n]))).toBeNull();
  });
});
