/**
 * Line weights and sizes in CSS pixels. They follow how long a typical spring appears on the screen, so that a net of ten springs
 * and one of ten thousand both read.
 */
export interface Strokes {
  spring: number;
  ghost: number;
  /** A torn piece: its line, how far its zigzag swings aside (0 where that would be lost), and the dots at its ends. */
  piece: number;
  pieceSwing: number;
  pieceDot: number;
  /** The spring it was torn from; 0 where that would only close the gaps. */
  pieceGhost: number;
  vertex: number;
  pin: number;
  pinHalo: number;
  arrow: number;
  arrowHead: number;
  halo: number;
}

export function strokesFor(springPixels: number): Strokes {
  const between = (least: number, most: number, share: number) => Math.max(least, Math.min(most, share * springPixels));
  const roomy = springPixels > 14;
  const zigzag = springPixels > 36;
  return {
    spring: between(1, 3.5, 0.05),
    ghost: between(1, 2, 0.03),
    piece: zigzag ? between(1.7, 3, 0.032) : between(1.25, 3, 0.12),
    pieceSwing: zigzag ? between(2.5, 10, 0.075) : 0,
    pieceDot: roomy ? between(1.5, 5, 0.06) : 0,
    pieceGhost: roomy ? between(1, 2, 0.03) : 0,
    vertex: roomy ? between(2, 6, 0.08) : 0,
    pin: between(3, 10, 0.24),
    pinHalo: between(0.3, 1.5, 0.05),
    arrow: between(1.2, 2.5, 0.035),
    arrowHead: between(5, 11, 0.15),
    halo: roomy ? between(0.8, 2, 0.022) : 0,
  };
}
