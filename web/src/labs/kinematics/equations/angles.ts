import { formatFixed, formatNumber } from '../../../lib/format.ts';

const degrees = 180 / Math.PI;

/** Degrees: below this an angle is what rounding left. */
const rounding = 1e-9;

/** Radians in degrees: one decimal, or two digits of less. */
export function formatAngle(radians: number): string {
  const shown = Math.abs(radians * degrees) < rounding ? 0 : radians * degrees;
  return `${shown === 0 || Math.abs(shown) >= 0.1 ? formatFixed(shown, 1) : formatNumber(shown, 2)}°`;
}

/** Radians in a column of degrees. */
export function formatDegrees(radians: number): string {
  return formatFixed(radians * degrees, 2);
}
