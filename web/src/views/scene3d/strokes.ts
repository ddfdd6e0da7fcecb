/** Line weights and sizes in CSS pixels: they follow how long a typical spring appears on the screen, so that a net of ten springs and one of ten thousand both read. */
export interface Strokes {
  spring: number;
  ghost: number;
  /** Dots at the ends of the torn pieces. */
  pieceDot: number;
  vertex: number;
  pin: number;
  arrow: number;
  arrowHead: number;
  halo: number;
  selected: number;
}

export function strokesFor(springPixels: number): Strokes {
  const between = (least: number, most: number, share: number) => Math.max(least, Math.min(most, share * springPixels));
  const spring = between(1, 4.5, 0.08);
  const roomy = springPixels > 14;
  return {
    spring,
    ghost: between(1, 2, 0.04),
    pieceDot: roomy ? between(1.5, 6, 0.1) : 0,
    vertex: roomy ? between(1.5, 6, 0.1) : 0,
    pin: between(4.5, 10, 0.2),
    arrow: between(1.2, 2.5, 0.05),
    arrowHead: between(5, 11, 0.2),
    halo: roomy ? between(0.8, 2.5, 0.05) : 0,
    selected: between(3, 4, 0.08),
  };
}
