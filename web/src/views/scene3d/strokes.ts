import type { Palette } from './palette.ts';

/**
 * Line weights and sizes in CSS pixels. They follow how long a typical spring appears on the screen, so that a net of ten springs
 * and one of ten thousand both read.
 */
export interface Strokes {
  /** A spring, whole or torn out: it is the same spring in both views. */
  spring: number;
  /** Radius of the dots at the ends of a torn piece; 0 where they would only close the gaps. */
  pieceDot: number;
  /** The spring it was torn from; 0 where that would only close the gaps. */
  pieceGhost: number;
  ghost: number;
  vertex: number;
  pin: number;
  pinHalo: number;
  arrow: number;
  arrowHead: number;
  halo: number;
  /** The glow of what is marked as a whole. */
  glow: number;
}

export function strokesFor(springPixels: number): Strokes {
  const between = (least: number, most: number, share: number) => Math.max(least, Math.min(most, share * springPixels));
  const roomy = springPixels > 14;
  return {
    spring: between(1.25, 4, 0.07),
    pieceDot: roomy ? between(1.75, 5, 0.075) : 0,
    pieceGhost: roomy ? between(1, 2, 0.03) : 0,
    ghost: between(1, 2, 0.03),
    vertex: roomy ? between(2, 6, 0.08) : 0,
    pin: between(3, 10, 0.24),
    pinHalo: between(0.3, 1.5, 0.05),
    arrow: between(1.5, 2.5, 0.035),
    arrowHead: between(6, 11, 0.15),
    halo: roomy ? between(0.8, 2, 0.022) : 0,
    glow: between(1, 3, 0.05),
  };
}

/** What parts a stroke from those behind it: a gap, or a glow where it is marked. */
export function haloFor(lit: boolean, palette: Palette, strokes: Strokes): { halo: number; haloColour: string } {
  return lit
    ? { halo: strokes.glow, haloColour: palette.glow }
    : { halo: strokes.halo, haloColour: palette.background };
}
