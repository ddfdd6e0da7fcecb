import { type Curve, distance } from '../../../curves/curve.ts';
import { gapsOf } from '../../../curves/gaps.ts';
import { largestError } from '../../../curves/largest_error.ts';
import { largestGap } from '../../../curves/largest_gap.ts';
import { type SampledCurve, sampleCurve } from '../../../curves/sample_curve.ts';
import type { Sampling } from '../../../curves/sampling.ts';
import { svg } from '../outline.ts';

/** How one sampling spreads its points over a curve. */
export interface Spread {
  sampled: SampledCurve;
  /** m. */
  largestGap: number;
  /** m. */
  meanGap: number;
  /** m. */
  error: number;
  /** SVG path data of the line over the largest gap. */
  gapLine: string;
}

export function spreadOf(curve: Curve, sampling: Sampling, points: number): Spread {
  const sampled = sampleCurve(curve, sampling, points);
  const gaps = gapsOf(sampled, curve);
  const largest = largestGap(sampled, curve);
  const { start, end } = gaps.find(({ at }) => at === largest.at) as (typeof gaps)[number];
  return {
    sampled,
    largestGap: largest.length,
    meanGap: gaps.reduce((sum, gap) => sum + distance(gap.start, gap.end), 0) / gaps.length,
    error: largestError(sampled, curve),
    gapLine: `M${svg(Float64Array.of(...start), 0)}L${svg(Float64Array.of(...end), 0)}`,
  };
}
