import { type IkOutcome, ikOutcomes } from '../../../solver/inverse_kinematics.ts';

/** Of all targets whose search took from `from` to `to` iterations, how many ended in which way. */
export interface Bin {
  from: number;
  to: number;
  count: number;
  ends: Record<IkOutcome, number>;
}

/** Bars at the most: more would be hairs. */
const mostBins = 40;

/** How many iterations a bin is wide where the largest count is `most`. */
export function binWidth(most: number): number {
  return [1, 2, 5, 10, 20, 50].find((width) => most + 1 <= mostBins * width) ?? 100;
}

/** From 0 iterations to `most`, in bins as wide as `binWidth` says; the empty ones too. */
export function histogram(iterations: ArrayLike<number>, outcomes: readonly IkOutcome[], most: number): Bin[] {
  const width = binWidth(most);
  const bins = Array.from({ length: Math.floor(most / width) + 1 }, (_, at): Bin => {
    return { from: at * width, to: (at + 1) * width - 1, count: 0, ends: noEnds() };
  });
  outcomes.forEach((outcome, at) => {
    const bin = bins[Math.floor(iterations[at] / width)];
    bin.count += 1;
    bin.ends[outcome] += 1;
  });
  return bins;
}

/** How many of the outcomes are which. */
export function countOutcomes(outcomes: readonly IkOutcome[]): Record<IkOutcome, number> {
  const ends = noEnds();
  for (const outcome of outcomes) ends[outcome] += 1;
  return ends;
}

/** Of an even number of values the mean of both in the middle. */
export function median(values: ArrayLike<number>): number {
  const sorted = Float64Array.from(values).sort();
  const middle = sorted.length / 2;
  return (sorted[Math.ceil(middle) - 1] + sorted[Math.floor(middle)]) / 2;
}

function noEnds(): Record<IkOutcome, number> {
  return Object.fromEntries(ikOutcomes.map((outcome) => [outcome, 0])) as Record<IkOutcome, number>;
}
