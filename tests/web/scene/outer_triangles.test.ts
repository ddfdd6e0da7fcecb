import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { outerTriangles } from '../../../web/src/scene/outer_triangles.ts';
import { enclosedVolume } from '../../support/enclosed_volume.ts';

// A cube of 1 m about the origin: corner i is at the signs of its three bits. Six tetrahedra around the diagonal from 0 to 7, 1/6 m³ each.
const cube = Float64Array.from({ length: 24 }, (_, c) => ((Math.floor(c / 3) >> (c % 3)) & 1) - 0.5);
const ring = [1, 3, 2, 6, 4, 5];
const tetrahedra = ring.map((i, step) => [0, i, ring[(step + 1) % 6], 7]);

describe('outerTriangles', () => {
  it('wraps a cube in twelve triangles, outwards, in whatever order the corners of its tetrahedra are written', () => {
    const orders = fc.tuple(...tetrahedra.map((corners) => fc.shuffledSubarray(corners, { minLength: 4 })));
    fc.assert(
      fc.property(orders, (rows) => {
        const F = outerTriangles(cube, Uint32Array.from(rows.flat()), []);
        expect(F).toHaveLength(3 * 12);
        expect(enclosedVolume(cube, F)).toBe(1); // every term a multiple of 1/24 of numbers ±½: nothing is rounded before the sixths
      }),
      { seed: 1 },
    );
  });

  it('leaves out a face that three tetrahedra share: none of them alone has it', () => {
    const V = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0, -1);
    const F = outerTriangles(V, Uint32Array.of(0, 1, 2, 3, 0, 1, 2, 4, 0, 1, 2, 5), []);
    expect(F).toHaveLength(3 * 9);
  });

  it('keeps a triangle that is no face of a tetrahedron as it is', () => {
    expect(outerTriangles(cube, new Uint32Array(0), [2, 1, 0])).toEqual([2, 1, 0]);
  });
});
