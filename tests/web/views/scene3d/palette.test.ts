import { describe, expect, it } from 'vitest';
import { parseColour } from '../../../../web/src/views/scene3d/colour.ts';
import { darkPalette, lightPalette } from '../../../../web/src/views/scene3d/palette.ts';

/** Contrast ratio of the Web Content Accessibility Guidelines, 1 … 21. */
function contrast(one: string, other: string): number {
  const luminance = (hex: string) => {
    const [red, green, blue] = parseColour(hex).map((byte) => {
      const c = byte / 255;
      return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  };
  const [darker, lighter] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (lighter + 0.05) / (darker + 0.05);
}

describe.each([lightPalette, darkPalette])('on $background', (palette) => {
  const { background, spring, vertex, arrow, pin, pull, selected, glow, strain, ghost } = palette;

  it.each([{ spring, vertex, arrow, pin, pull, selected, compressed: strain[0], stretched: strain[4] }])(
    'what carries meaning has the 3 : 1 that graphics need',
    (colours) => {
      for (const colour of Object.values(colours)) expect(contrast(colour, background)).toBeGreaterThanOrEqual(3);
    },
  );

  it('what is selected stands out from its glow', () => {
    expect(contrast(selected, glow)).toBeGreaterThanOrEqual(3);
  });

  it('ghosts are fainter than every spring', () => {
    for (const colour of [spring, ...strain]) {
      expect(contrast(ghost, background)).toBeLessThan(contrast(colour, background));
    }
  });
});
