import { type Curve, distance } from './curve.ts';
import { gapsOf } from './gaps.ts';
import type { SampledCurve } from './sample_curve.ts';

/** The longest way, in m, from a point to the next of its stroke, and the index of that point. */
export function largestGap(sampled: SampledCurve, curve: Curve): { length: number; at: number } {
  let largest = { length: 0, at: 0 };
  for (const { at, start, end } of gapsOf(sampled, curve)) {
    const length = distance(start, end);
    if (length > largest.length) largest = { length, at };
  }
  return largest;
}
