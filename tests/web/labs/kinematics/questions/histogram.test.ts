import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  binWidth,
  countOutcomes,
  histogram,
  median,
} from '../../../../../web/src/labs/kinematics/questions/histogram.ts';
import { ikOutcomes } from '../../../../../web/src/solver/inverse_kinematics.ts';

const counted = fc.array(fc.tuple(fc.integer({ min: 0, max: 1000 }), fc.constantFrom(...ikOutcomes)), { minLength: 1 });

describe('a histogram', () => {
  it('holds every target once, in the bin of its iterations and under the way it ended', () => {
    fc.assert(
      fc.property(counted, (targets) => {
        const [iterations, outcomes] = [targets.map(([made]) => made), targets.map(([, outcome]) => outcome)];
        const bins = histogram(iterations, outcomes, Math.max(...iterations));
        const total = bins.reduce((sum, { count }) => sum + count, 0);
        expect(total).toBe(targets.length);
        for (const { from, to, count, ends } of bins) {
          expect(count).toBe(iterations.filter((made) => made >= from && made <= to).length);
          expect(Object.values(ends).reduce((sum, part) => sum + part)).toBe(count);
        }
        for (const outcome of ikOutcomes)
          expect(bins.reduce((sum, { ends }) => sum + ends[outcome], 0)).toBe(countOutcomes(outcomes)[outcome]);
      }),
    );
  });

  it('has a bar for every number of iterations as long as they are few, and at most 40', () => {
    expect(binWidth(22)).toBe(1);
    expect(binWidth(39)).toBe(1);
    expect(binWidth(40)).toBe(2);
    expect(binWidth(200)).toBe(10);
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 1000 }), (most) => {
        expect(histogram([most], ['STALLED'], most).length).toBeLessThanOrEqual(40);
      }),
    );
  });
});

it('the median is the middle one, or the mean of the middle two', () => {
  expect(median([5, 1, 3])).toBe(3);
  expect(median([8, 1, 3, 4])).toBe(3.5);
  expect(median(Int32Array.of(7))).toBe(7);
});
