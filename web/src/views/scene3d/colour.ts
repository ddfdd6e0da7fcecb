/** sRGB, 0 … 255 each. */
export type Rgb = [number, number, number];

export function parseColour(hex: string): Rgb {
  const value = Number.parseInt(hex.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

/** Straight between two colours in sRGB, as a CSS gradient mixes them. */
export function mixColours(from: Rgb, to: Rgb, fraction: number): Rgb {
  return [0, 1, 2].map((c) => Math.round(from[c] + fraction * (to[c] - from[c]))) as Rgb;
}

/** Likewise of "#rrggbb". */
export function mixHex(from: string, to: string, fraction: number): string {
  const channels = mixColours(parseColour(from), parseColour(to), fraction);
  return `#${channels.map((channel) => channel.toString(16).padStart(2, '0')).join('')}`;
}
