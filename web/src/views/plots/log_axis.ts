/** Whole decades around all heights, at least one of them; some decade when there is nothing to show. */
export function decadesAround(lowest: number | null, highest: number | null): [number, number] {
  if (lowest === null || highest === null) return [1e-3, 1];
  const first = Math.floor(Math.log10(lowest));
  const last = Math.max(Math.ceil(Math.log10(highest)), first + 1);
  return [10 ** first, 10 ** last];
}

/** Exponents of the powers of ten between two of them, thinned evenly to at most `most`. */
export function decadeTicks(lowest: number, highest: number, most: number): number[] {
  const first = Math.round(Math.log10(lowest));
  const last = Math.round(Math.log10(highest));
  const stride = Math.ceil((last - first + 1) / most);
  return Array.from({ length: Math.floor((last - first) / stride) + 1 }, (_, index) => first + index * stride);
}
