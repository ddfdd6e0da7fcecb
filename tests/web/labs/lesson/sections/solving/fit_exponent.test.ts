import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fitExponent } from '../../../../../../web/src/labs/lesson/sections/solving/fit_exponent.ts';

const sizes = [25, 100, 400, 1600];

describe('fitExponent', () => {
  it('finds the law that the points obey', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 0, max: 4, noNaN: true }),
        fc.double({ min: 1e-6, max: 10, noNaN: true }),
        (exponent, factor) => {
          const law = fitExponent(sizes.map((n) => ({ n, milliseconds: factor * n ** exponent })));
          // Logarithms up to 40 are rounded to 1e-14 of themselves and divided by their spread of 4.
          expect(law?.exponent).toBeCloseTo(exponent, 11);
          expect(law && law.factor / factor).toBeCloseTo(1, 10);
        },
      ),
    );
  });

  it('is not misled by errors that cancel: twice as long at one end and at the other', () => {
    const times = sizes.map((n, at) => ({ n, milliseconds: n * (at === 0 || at === 3 ? 2 : 1) }));
    expect(fitExponent(times)?.exponent).toBeCloseTo(1, 12);
  });

  it('wants three points at least', () => {
    expect(fitExponent(sizes.slice(0, 2).map((n) => ({ n, milliseconds: n })))).toBeNull();
  });
});
