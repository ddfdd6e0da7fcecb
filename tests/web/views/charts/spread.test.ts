import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { spread } from '../../../../web/src/views/charts/spread.ts';

describe('spread', () => {
  it('leaves alone what is far enough apart', () => {
    expect(spread([80, 20], 16, [0, 100])).toEqual([80, 20]);
  });

  it('moves apart what is too near, from the top down, and back in where it leaves the range', () => {
    expect(spread([10, 12], 16, [0, 100])).toEqual([10, 26]);
    expect(spread([98, 97], 16, [0, 100])).toEqual([100, 84]);
  });

  it('keeps order, distances and range, where there is room for all', () => {
    fc.assert(
      fc.property(fc.array(fc.integer({ min: -50, max: 250 }), { maxLength: 10 }), (wanted) => {
        const places = spread(wanted, 16, [0, 200]);
        const order = [...wanted.keys()].sort((a, b) => wanted[a] - wanted[b]);
        for (const [before, at] of order.entries()) {
          expect(places[at]).toBeGreaterThanOrEqual(0);
          expect(places[at]).toBeLessThanOrEqual(200);
          if (before > 0) expect(places[at] - places[order[before - 1]]).toBeGreaterThanOrEqual(16);
        }
      }),
    );
  });
});
