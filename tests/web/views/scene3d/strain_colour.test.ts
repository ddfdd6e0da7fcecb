import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { parseColour } from '../../../../web/src/views/scene3d/colour.ts';
import { darkPalette, lightPalette } from '../../../../web/src/views/scene3d/palette.ts';
import { strainColour } from '../../../../web/src/views/scene3d/strain_colour.ts';

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
