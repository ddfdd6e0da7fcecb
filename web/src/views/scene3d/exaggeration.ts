/** 1, 2, 5 times a power of ten, from `least` to `most` inclusive. */
export function steps125(least: number, most: number): number[] {
  const steps: number[] = [];
  for (let exponent = Math.round(Math.log10(least)); 10 ** exponent <= most; exponent++) {
    for (const digit of [1, 2, 5]) steps.push(Number(`${digit}e${exponent}`));
  }
  return steps.filter((step) => step >= least && step <= most);
}

export const exaggerations = steps125(1, 1000);
export const strainRanges = steps125(1e-4, 1);

/** How far the ideal may wander from the step in use before another is taken; over half of the widest stride, 5/2, so that neighbours overlap. */
const reluctance = 3;

/**
 * The step nearest to `ideal`, but the one in use (`current`, if any) as long as it still serves: numbers in a legend
 * must not flicker while a net swings.
 */
export function settle(ideal: number, current: number | undefined, steps: readonly number[]): number {
  const bounded = Math.max(steps[0], Math.min(steps[steps.length - 1], ideal));
  if (current !== undefined && bounded < current * reluctance && bounded > current / reluctance) return current;
  const distance = (step: number) => Math.abs(Math.log(step / bounded));
  return steps.reduce((best, step) => (distance(step) < distance(best) ? step : best));
}

/** At most this many values are looked at: enough for a percentile, and cheap on the largest scene. */
const sampleSize = 1024;

/** The value that the fraction `q` of `value(0 … count−1)` does not exceed; 0 of none. */
export function quantile(count: number, value: (index: number) => number, q: number): number {
  if (count === 0) return 0;
  const stride = Math.ceil(count / sampleSize);
  const sample = new Float64Array(Math.ceil(count / stride));
  for (let s = 0; s < sample.length; s++) sample[s] = value(s * stride);
  sample.sort();
  return sample[Math.min(sample.length - 1, Math.floor(q * sample.length))];
}
