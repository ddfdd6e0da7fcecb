export function sum(values: number[]): number {
  return values.reduce((a, b) => a + b, 0);
}

export function median(values: number[]): number {
  return values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];
}

/** α of y ≈ c x^α: the slope of the least squares line through (log x, log y). */
export function exponent(x: number[], y: number[]): number {
  const u = x.map(Math.log);
  const centre = sum(u) / u.length;
  return sum(u.map((value, i) => (value - centre) * Math.log(y[i]))) / sum(u.map((value) => (value - centre) ** 2));
}
