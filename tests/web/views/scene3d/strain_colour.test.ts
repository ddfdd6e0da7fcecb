import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { packColour, parseColour } from '../../../../web/src/views/scene3d/colour.ts';
import { darkPalette, lightPalette } from '../../../../web/src/views/scene3d/palette.ts';
import { StrainColourTable, strainColour } from '../../../../web/src/views/scene3d/strain_colour.ts';

const scale = lightPalette.strain;
const range = 0.1;

describe('strainColour', () => {
  it.each([
    [-0.1, 0],
    [-0.05, 1],
    [0, 2],
    [0.05, 3],
    [0.1, 4],
  ])('at strain %f of a range of 0.1 it is stop %i of the scale', (strain, stop) => {
    expect(strainColour(strain, range, scale)).toEqual(parseColour(scale[stop]));
  });

  it('halfway between two stops it is their mean, as a CSS gradient mixes', () => {
    expect(strainColour(1, 4, ['#000000', '#000000', '#000000', '#64c8ff', '#000000'])).toEqual([50, 100, 128]);
  });

  it('beyond the range it stays at the end, infinity included', () => {
    expect(strainColour(-7, range, scale)).toEqual(parseColour(scale[0]));
    expect(strainColour(Number.POSITIVE_INFINITY, range, scale)).toEqual(parseColour(scale[4]));
  });

  it.each([lightPalette, darkPalette])('springs as short and as long as each other never look alike', ({ strain }) => {
    fc.assert(
      fc.property(fc.double({ min: 0.02, max: 0.1, noNaN: true }), (size) => {
        expect(strainColour(size, range, strain)).not.toEqual(strainColour(-size, range, strain));
      }),
    );
  });
});

it('the table holds the colours of strainColour, at most one of its strides away', () => {
  const table = new StrainColourTable(scale);
  fc.assert(
    fc.property(fc.double({ min: -0.2, max: 0.2, noNaN: true }), (strain) => {
      const packed = table.colour(strain, range);
      const exact = strainColour(strain, range, scale);
      // Half a stride is 1/254 of the range; the steepest channel runs through 178 of 255 in half the range: 1.4, and half for rounding.
      [packed >> 16, (packed >> 8) & 255, packed & 255].forEach((channel, c) => {
        expect(Math.abs(channel - exact[c])).toBeLessThanOrEqual(2);
      });
    }),
  );
});

it('packed colours survive single precision, in which they travel', () => {
  fc.assert(
    fc.property(fc.integer({ min: 0, max: 0xffffff }), (value) => {
      const hex = `#${value.toString(16).padStart(6, '0')}`;
      expect(Math.fround(packColour(parseColour(hex)))).toBe(value);
    }),
  );
});
