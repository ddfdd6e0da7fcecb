/** How an axis runs: from `min` to `max`, both finite and min < max, in equal steps or in equal factors. */
export interface Range {
  min: number;
  max: number;
  logarithmic: boolean;
}

/** Where a value lies between both ends of the axis: 0 … 1. */
export function share(value: number, { min, max, logarithmic }: Range): number {
  return logarithmic ? Math.log(value / min) / Math.log(max / min) : (value - min) / (max - min);
}

/** Round values along the axis: powers of ten, or about five steps of 1, 2 or 5 times one. */
export function ticks({ min, max, logarithmic }: Range): number[] {
  if (logarithmic) {
    const [first, last] = [Math.ceil(Math.log10(min) - 1e-9), Math.floor(Math.log10(max) + 1e-9)];
    return Array.from({ length: last - first + 1 }, (_, at) => 10 ** (first + at));
  }
  const rough = (max - min) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((digit) => digit * power >= rough * 0.999) as number);
  const first = Math.ceil(min / step - 1e-9);
  const count = Math.floor(max / step + 1e-9) - first + 1;
  return Array.from({ length: count }, (_, at) => Number(((first + at) * step).toPrecision(12)));
}

/** From the least to the greatest of the values that can be drawn. */
export function rangeOf(values: readonly number[], logarithmic: boolean): Range {
  const drawn = values.filter((value) => Number.isFinite(value) && (!logarithmic || value > 0));
  const min = drawn.reduce((least, value) => Math.min(least, value), Number.POSITIVE_INFINITY);
  const max = drawn.reduce((most, value) => Math.max(most, value), Number.NEGATIVE_INFINITY);
  if (min < max) return { min, max, logarithmic };
  const middle = drawn.length > 0 ? min : 1;
  return logarithmic
    ? { min: middle / 10, max: middle * 10, logarithmic }
    : { min: middle - 1, max: middle + 1, logarithmic };
}
