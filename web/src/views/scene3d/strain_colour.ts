import { mixColours, parseColour, type Rgb } from './colour.ts';
import type { StrainScale } from './palette.ts';

/**
 * The colour of a strain (l − r)/r, dimensionless, when |strain| = range has full colour. Legends use it too; the CSS gradient through
 * the scale's colours is the same scale, since both mix straight in sRGB.
 */
export function strainColour(strain: number, range: number, scale: StrainScale): Rgb {
  const stride = 2 + 2 * Math.max(-1, Math.min(1, strain / range));
  const below = Math.min(3, Math.floor(stride));
  return mixColours(parseColour(scale[below]), parseColour(scale[below + 1]), stride - below);
}
