import { describe, expect, it } from 'vitest';
import { rangeOf, share, ticks } from '../../../../web/src/views/charts/chart_axis.ts';

describe('rangeOf', () => {
  it('goes on to round values', () => {
    expect(rangeOf([0.04, 0.93], false)).toEqual({ min: 0, max: 1, logarithmic: false });
    expect(rangeOf([3e-4, 70], true)).toEqual({ min: 1e-4, max: 100, logarithmic: true });
  });

  it('leaves out what cannot be drawn', () => {
    expect(rangeOf([Number.NaN, Number.POSITIVE_INFINITY, 0, 2, 50], true)).toMatchObject({ min: 1, max: 100 });
  });

  it('is a range even of one value, or none', () => {
    for (const values of [[], [0], [5, 5]])
      for (const logarithmic of [false, true]) {
        const { min, max } = rangeOf(values, logarithmic);
        expect(max).toBeGreaterThan(min);
      }
  });
});

describe('ticks', () => {
  it('are some round values from end to end', () => {
    expect(ticks({ min: 0, max: 1, logarithmic: false })).toEqual([0, 0.2, 0.4, 0.6, 0.8, 1]);
    expect(ticks({ min: -0.95, max: -0.8, logarithmic: false })).toEqual([-0.95, -0.9, -0.85, -0.8]);
  });

  it('are the powers of ten on a logarithmic axis', () => {
    expect(ticks({ min: 1e-3, max: 10, logarithmic: true })).toEqual([1e-3, 1e-2, 0.1, 1, 10]);
  });
});

describe('share', () => {
  it('measures along equal steps or equal factors', () => {
    expect(share(3, { min: 1, max: 5, logarithmic: false })).toBe(0.5);
    expect(share(10, { min: 1, max: 100, logarithmic: true })).toBeCloseTo(0.5, 12);
  });
});
