import { median } from './statistics.ts';

/** How long something is repeated, and at least how often. */
const repeatedFor = 100; // ms
const leastRepetitions = 4;

export function milliseconds(call: () => void): number {
  const start = performance.now();
  call();
  return performance.now() - start;
}

/** The median of what `once` returns (ms) over many repetitions, of which the first half warms up. */
export function typical(once: () => number): number {
  const times: number[] = [];
  for (let total = 0; total < repeatedFor || times.length < leastRepetitions; total += times[times.length - 1]) {
    times.push(once());
  }
  return median(times.slice(times.length / 2));
}
