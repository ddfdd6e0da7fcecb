import { formatPowerOfTen } from '../../lib/format.ts';

/** Whole decades around all heights, at least one of them; some decade when there is nothing to show. */
export function decades(lowest: number | null, highest: number | null): [number, number] {
  if (lowest === null || highest === null) return [1e-3, 1];
  const first = Math.floor(Math.log10(lowest));
  const last = Math.max(Math.ceil(Math.log10(highest)), first + 1);
  return [10 ** first, 10 ** last];
}

/** Labels at powers of ten only; `null` marks a tick that has no room for one. */
export function decadeLabels(ticks: readonly (number | null)[]): string[] {
  return ticks.map((tick) => {
    if (tick === null) return '';
    const exponent = Math.log10(tick);
    return Math.abs(exponent - Math.round(exponent)) < 1e-9 ? formatPowerOfTen(Math.round(exponent)) : '';
  });
}
