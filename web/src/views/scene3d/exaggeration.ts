import { steps125 } from '../../lib/steps_125.ts';

export const strainRanges = steps125(1e-4, 1);

/** How far a bound may wander from the step in use before another is taken; over the widest stride, 5/2, so that the choice does not flicker. */
const slack = 3;

/**
 * The largest step that is not above `most` (the first when all are), but the one in use (`current`, if any) as long as it is not
 * far below: numbers in a legend must not flicker while a net swings.
 */
export function settleBelow(most: number, current: number | undefined, steps: readonly number[]): number {
  if (current !== undefined && current <= most && slack * current > Math.min(most, steps[steps.length - 1]))
    return current;
  return steps.findLast((step) => step <= most) ?? steps[0];
}

/** The same from the other side: the smallest step that is not below `least` (the last when all are). */
export function settleAbove(least: number, current: number | undefined, steps: readonly number[]): number {
  if (current !== undefined && current >= least && current < slack * Math.max(least, steps[0])) return current;
  return steps.find((step) => step >= least) ?? steps[steps.length - 1];
}

/** At most this many values are looked at: enough for a percentile, and cheap on the largest scene. */
const sample = new Float64Array(1024);

/** The value that the fraction `q` of `value(0 … count−1)` does not exceed; 0 of none. */
export function quantile(count: number, value: (index: number) => number, q: number): number {
  if (count === 0) return 0;
  const stride = Math.ceil(count / sample.length);
  const taken = sample.subarray(0, Math.ceil(count / stride));
  for (let s = 0; s < taken.length; s++) taken[s] = value(s * stride);
  taken.sort();
  return taken[Math.min(taken.length - 1, Math.floor(q * taken.length))];
}
