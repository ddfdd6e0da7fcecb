/** A power law y = c xᵃ. */
export interface PowerLaw {
  exponent: number;
  /** c. */
  factor: number;
  /** What it was fitted to. */
  points: readonly Point[];
}

type Point = readonly [x: number, y: number];

/** The straight line through (log x, log y) with the least sum of squares. Null for fewer than three points: two always fit. */
export function fitPowerLaw(points: readonly Point[]): PowerLaw | null {
  if (points.length < 3) return null;
  const x = points.map(([at]) => Math.log(at));
  const y = points.map(([, value]) => Math.log(value));
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
