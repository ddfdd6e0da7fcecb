import { mixColours, packColour, parseColour, type Rgb } from './colour.ts';
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

const half = 127;

/** `strainColour`, for every spring of a large scene once a frame. */
export class StrainColourTable {
  readonly scale: StrainScale;
  /** 2·half+1 packed colours, from strain −range to +range. */
  private readonly packed: number[];

  constructor(scale: StrainScale) {
    this.scale = scale;
    this.packed = Array.from({ length: 2 * half + 1 }, (_, row) => packColour(strainColour(row - half, half, scale)));
  }

  /** The packed colour of a strain, at most half a row off. */
  colour(strain: number, range: number): number {
    return this.packed[half + Math.round(half * Math.max(-1, Math.min(1, strain / range)))];
  }
}
