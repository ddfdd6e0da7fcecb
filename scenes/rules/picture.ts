/** An opaque picture. */
export interface Picture {
  width: number;
  height: number;
  /** width·height × 3, one byte each of red, green, blue; rows from the top. */
  pixels: Uint8Array;
}

export type Colour = readonly [red: number, green: number, blue: number];

export const ivory: Colour = [246, 241, 231];
export const sand: Colour = [222, 211, 192];
export const slate: Colour = [44, 62, 80];
export const vermilion: Colour = [213, 94, 0];

/**
 * Gives each pixel the mean colour of samples × samples points in it: more than one makes edges smooth. `colourAt` takes x to the right and y downwards,
 * in pixels.
 */
export function paint(
  width: number,
  height: number,
  samples: number,
  colourAt: (x: number, y: number) => Colour,
): Picture {
  const pixels = new Uint8Array(3 * width * height);
  for (let pixel = 0; pixel < width * height; pixel++) {
    const sum = [0, 0, 0];
    for (let sample = 0; sample < samples ** 2; sample++) {
      const x = (pixel % width) + ((sample % samples) + 0.5) / samples;
      const y = Math.floor(pixel / width) + (Math.floor(sample / samples) + 0.5) / samples;
      for (const [channel, value] of colourAt(x, y).entries()) sum[channel] += value;
    }
    pixels.set(
      sum.map((value) => Math.round(value / samples ** 2)),
      3 * pixel,
    );
  }
  return { width, height, pixels };
}
