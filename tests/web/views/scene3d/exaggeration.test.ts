import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { exaggerations, quantile, settle, steps125 } from '../../../../web/src/views/scene3d/exaggeration.ts';

it('steps are 1, 2, 5 times powers of ten', () => {
  expect(exaggerations).toEqual([1, 2, 5, 10, 20, 50, 100, 200, 500, 1000]);
  expect(steps125(0.01, 0.5)).toEqual([0.01, 0.02, 0.05, 0.1, 0.2, 0.5]);
});

describe('settle', () => {
  const ideal = fc.double({ min: 0, noNaN: true });
  const step = fc.constantFrom(...exaggerations);

  it('takes the nearest step, in ratio, when nothing is in use', () => {
    expect(settle(3, undefined, exaggerations)).toBe(2); // 3/2 < 5/3
    expect(settle(3.3, undefined, exaggerations)).toBe(5); // 5/3.3 < 3.3/2
  });

  it('always takes one of the steps, and the outermost beyond them', () => {
    fc.assert(fc.property(ideal, step, (x, current) => exaggerations.includes(settle(x, current, exaggerations))));
    expect(settle(Number.POSITIVE_INFINITY, undefined, exaggerations)).toBe(1000);
    expect(settle(0, undefined, exaggerations)).toBe(1);
  });

  it('stays where it is: the same ideal never moves it twice', () => {
    fc.assert(
      fc.property(ideal, step, (x, current) => {
        const once = settle(x, current, exaggerations);
        expect(settle(x, once, exaggerations)).toBe(once);
      }),
    );
  });

  it('a swing of ±50 % about where it settled does not flicker', () => {
    // The nearest step is at most √(5/2) = 1.58 away in ratio, and 1.58 · 1.5 < 3, the reluctance.
    fc.assert(
      fc.property(
        fc.double({ min: 1, max: 1000, noNaN: true }),
        fc.double({ min: 1 / 1.5, max: 1.5, noNaN: true }),
        (x, s) => {
          const settled = settle(x, undefined, exaggerations);
          expect(settle(x * s, settled, exaggerations)).toBe(settled);
        },
      ),
    );
  });
});

describe('quantile', () => {
  it('of 0 … 9', () => {
    expect(quantile(10, (i) => i, 0)).toBe(0);
    expect(quantile(10, (i) => 9 - i, 0.8)).toBe(8);
    expect(quantile(10, (i) => i, 1)).toBe(9);
  });

  it('of nothing is zero', () => {
    expect(quantile(0, () => Number.NaN, 0.5)).toBe(0);
  });

  it('of many, a sample is as good: within 1 % of the rank', () => {
    // 28,000 values are sampled with stride 28: ranks are at most 28/28000 off.
    expect(quantile(28_000, (i) => i / 28_000, 0.8)).toBeCloseTo(0.8, 2);
  });
});
