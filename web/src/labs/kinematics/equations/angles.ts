import { formatFixed, formatQuantity } from '../../../lib/format.ts';

const degrees = 180 / Math.PI;

/** Whether an angle, rad, is no more than what rounding left. */
export function isNoAngle(radians: number): boolean {
  return Math.abs(radians) < 1e-11;
}

/** Radians in degrees: one decimal, or two digits of less. */
export function formatAngle(radians: number): string {
  const shown = isNoAngle(radians) ? 0 : radians * degrees;
  return shown === 0 || Math.abs(shown) >= 0.1 ? `${formatFixed(shown, 1)}°` : formatQuantity(shown, '°', 2);
}

/** Radians in a column of degrees. */
export function formatDegrees(radians: number): string {
  return formatFixed(radians * degrees, 2);
}
