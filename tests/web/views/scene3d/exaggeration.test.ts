import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { exaggerations } from '../../../../web/src/app/limits.ts';
import { quantile, settleAbove, settleBelow } from '../../../../web/src/views/scene3d/exaggeration.ts';

const bound = fc.double({ min: 0, noNaN: true });
const step = fc.constantFrom(undefined, ...exaggerations);

describe.each([
  { settle: settleBelow, holds: (chosen: number, most: number) => chosen <= Math.max(most, 1) },
  { settle: settleAbove, holds: (chosen: number, least: number) => chosen >= Math.min(least, 1000) },
])('$settle.name', ({ settle, holds }) => {
  it('takes a step that keeps the bound, or the outermost', () => {
    fc.assert(
      fc.property(bound, step, (x, current) => {
        const chosen = settle(x, current, exaggerations);
        expect(exaggerations).toContain(chosen);
        expect(holds(chosen, x)).toBe(true);
      }),
    );
    expect(settle(Number.POSITIVE_INFINITY, undefined, exaggerations)).toBe(1000);
    expect(settle(0, undefined, exaggerations)).toBe(1);
  });

  it('takes a step at most three times off a bound within their range', () => {
    fc.assert(
      fc.property(fc.double({ min: 1, max: 1000, noNaN: true }), step, (x, current) => {
        expect(Math.abs(Math.log(settle(x, current, exaggerations) / x))).toBeLessThanOrEqual(Math.log(3));
      }),
    );
  });

  it('stays where it is: the same bound never moves it twice', () => {
    fc.assert(
      fc.property(bound, step, (x, current) => {
        const once = settle(x, current, exaggerations);
        expect(settle(x, once, exaggerations)).toBe(once);
      }),
    );
  });
});

it('a bound that swings across a step moves the choice once', () => {
  expect(settleBelow(4.9, 5, exaggerations)).toBe(2);
  expect(settleBelow(5.1, 2, exaggerations)).toBe(2);
  expect(settleAbove(5.1, 5, exaggerations)).toBe(10);
  expect(settleAbove(4.9, 10, exaggerations)).toBe(10);
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
