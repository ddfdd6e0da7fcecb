import { columnScale, formatFixed, formatInColumn, formatNumber } from './format.ts';

/** Entries whose sizes differ by more than this factor cannot share a scale: the small ones would all read 0. */
const widest = 1e4;

/** How the entries of a matrix are written: whole numbers as such, others in one scale if they can share one. Zero is always "0". */
export function entryFormat(
  values: ArrayLike<number>,
  unit: string | null,
): { unit: string | null; write(value: number): string } {
  const sizes = Array.from(values, Math.abs).filter((size) => size > 0);
  const largest = sizes.reduce((most, size) => Math.max(most, size), 0);
  const smallest = sizes.reduce((least, size) => Math.min(least, size), Number.POSITIVE_INFINITY);
  const writeEach = (write: (value: number) => string) => (value: number) => (value === 0 ? '0' : write(value));
  if (largest < widest && sizes.every(Number.isInteger)) return { unit, write: (value) => formatFixed(value, 0) };
  if (largest > widest * smallest) return { unit, write: writeEach(formatNumber) };
  const scale = columnScale(largest, unit ?? '', 3);
  return { unit: scale.unit || null, write: writeEach((value) => formatInColumn(value, scale)) };
}
