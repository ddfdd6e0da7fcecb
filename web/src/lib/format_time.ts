import { formatQuantity } from './format.ts';

/** In the unit that suits: "12.5 µs", "3.10 ms", "1.20 s". */
export function formatTime(milliseconds: number, digits = 3): string {
  if (milliseconds < 1) return formatQuantity(1e3 * milliseconds, 'µs', digits);
  if (milliseconds < 1e3) return formatQuantity(milliseconds, 'ms', digits);
  return formatQuantity(milliseconds / 1e3, 's', digits);
}
