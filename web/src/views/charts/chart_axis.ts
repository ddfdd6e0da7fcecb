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

/** Round values along the axis: powers of ten, or some steps of 1, 2 or 5 times one. */
export function ticks({ min, max, logarithmic }: Range): number[] {
  const step = logarithmic ? 1 : roundStep(max - min);
  const [first, last] = logarithmic ? [Math.log10(min), Math.log10(max)] : [min / step, max / step];
  const count = Math.floor(last + grain) - Math.ceil(first - grain) + 1;
  const steps = Array.from({ length: count }, (_, at) => Math.ceil(first - grain) + at);
  return steps.map((at) => (logarithmic ? powerOfTen(at) : Number((at * step).toPrecision(12))));
}

/** From the least to the greatest of the values that can be drawn, and on to round ones. */
export function rangeOf(values: readonly number[], logarithmic: boolean): Range {
  const drawn = values.filter((value) => Number.isFinite(value) && (!logarithmic || value > 0));
  const least = drawn.reduce((a, b) => Math.min(a, b), drawn[0] ?? 1);
  const most = drawn.reduce((a, b) => Math.max(a, b), least);
  if (logarithmic) {
    const [first, last] = [Math.floor(Math.log10(least) + grain), Math.ceil(Math.log10(most) - grain)];
    return { min: powerOfTen(first), max: powerOfTen(Math.max(last, first + 1)), logarithmic };
  }
  const step = roundStep(most - least || 1);
  const first = Math.floor(least / step + grain);
  const last = Math.max(Math.ceil(most / step - grain), first + 1);
  return { min: Number((first * step).toPrecision(12)), max: Number((last * step).toPrecision(12)), logarithmic };
}

/** As it is written: 10 ** −4 is not 1e-4. */
function powerOfTen(exponent: number): number {
  return Number(`1e${exponent}`);
}

/** Of a step: what rounding may have put a value beside the tick that it is. */
const grain = 1e-9;

/** About a fifth of the extent. */
function roundStep(extent: number): number {
  const power = 10 ** Math.floor(Math.log10(extent / 5));
  const digit = [1, 2, 5].find((candidate) => candidate * power >= (extent / 5) * (1 - grain)) ?? 10;
  return digit * power;
}
