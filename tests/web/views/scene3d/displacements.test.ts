import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { displacement, interpolatePoints, thinned } from '../../../../web/src/views/scene3d/displacements.ts';

describe('thinned', () => {
  const cloud = fc.array(fc.double({ min: -1, max: 1, noNaN: true }), { minLength: 3, maxLength: 300 }).map((row) => {
    return Float64Array.from(row.slice(0, row.length - (row.length % 3)));
  });

  it('keeps no more than asked for, at least one, each once, in order', () => {
    fc.assert(
      fc.property(cloud, fc.integer({ min: 8, max: 40 }), (V, most) => {
        const kept = thinned(V, most);
        expect(kept.length).toBeLessThanOrEqual(most);
        expect(kept.length).toBeGreaterThan(0);
        expect([...kept]).toEqual([...new Set(kept)].sort((a, b) => a - b));
      }),
    );
  });

  it('keeps all of a small net', () => {
    expect([...thinned(new Float64Array(9), 3)]).toEqual([0, 1, 2]);
  });

  it('spreads over a cloth: every quarter of it keeps a quarter of the arrows, about', () => {
    const side = 60;
    const V = Float64Array.from({ length: 3 * side * side }, (_, at) => {
      const v = Math.floor(at / 3);
      return [v % side, Math.floor(v / side), 0][at % 3];
    });
    const kept = [...thinned(V, 400)];
    const corner = kept.filter((v) => v % side < side / 2 && v < V.length / 6);
    // The grid's cells need not end at the middle: one row of cells in ten either way.
    expect(corner.length / kept.length).toBeGreaterThan(0.2);
    expect(corner.length / kept.length).toBeLessThan(0.3);
  });
});

it('interpolatePoints goes straight from one net to the other', () => {
  const out = new Float64Array(3);
  interpolatePoints(Float64Array.of(0, 2, 4), Float64Array.of(4, 2, 0), 0.25, out);
  expect([...out]).toEqual([1, 2, 3]);
});

it('displacement is the distance between rows', () => {
  expect(displacement(Float64Array.of(9, 9, 9, 0, 0, 0), Float64Array.of(9, 9, 9, 2, 3, 6), 1)).toBe(7);
});
