/** A power law t = c nᵃ, t in ms. */
export interface PowerLaw {
  exponent: number;
  /** c. */
  factor: number;
  /** What it was fitted to, smallest n first. */
  points: readonly TimeOfSize[];
}

export interface TimeOfSize {
  n: number;
  milliseconds: number;
}

/** The straight line through (log n, log t) with the least sum of squares. Null for fewer than three points: two always fit. */
export function fitExponent(points: readonly TimeOfSize[]): PowerLaw | null {
  if (points.length < 3) return null;
  const x = points.map(({ n }) => Math.log(n));
  const y = points.map(({ milliseconds }) => Math.log(milliseconds));
  const meanX = mean(x);
  const meanY = mean(y);
  const exponent =
    sum(x.map((value, index) => (value - meanX) * (y[index] - meanY))) / sum(x.map((value) => (value - meanX) ** 2));
  return { exponent, factor: Math.exp(meanY - exponent * meanX), points };
}

function sum(values: readonly number[]): number {
  return values.reduce((total, value) => total + value, 0);
}

function mean(values: readonly number[]): number {
  return sum(values) / values.length;
}
