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

const half = 127;

/** `strainColour` for every spring of a large scene, once a frame. */
export class StrainColourTable {
  /** (2·half+1)×3, sRGB bytes from strain −range to +range. */
  private readonly table: Uint8Array;

  constructor(scale: StrainScale) {
    this.table = new Uint8Array((2 * half + 1) * 3);
    for (let row = 0; row <= 2 * half; row++) this.table.set(strainColour(row - half, half, scale), row * 3);
  }

  /** Writes the colour of `strain` as three bytes to `out[at …]`. */
  write(strain: number, range: number, out: Uint8Array, at: number): void {
    const row = half + Math.round(half * Math.max(-1, Math.min(1, strain / range)));
    out[at] = this.table[row * 3];
    out[at + 1] = this.table[row * 3 + 1];
    out[at + 2] = this.table[row * 3 + 2];
  }
}
