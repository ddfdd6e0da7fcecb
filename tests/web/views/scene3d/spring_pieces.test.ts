import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  pieceEnds,
  pieceLength,
  springEnds,
  strain,
  writePieces,
} from '../../../../web/src/views/scene3d/spring_pieces.ts';

const E = Int32Array.of(0, 1);
const coordinate = fc.double({ min: -2, max: 2, noNaN: true });
const points = fc.array(coordinate, { minLength: 6, maxLength: 6 }).map((row) => Float64Array.from(row));
const restLength = fc.double({ min: 0.01, max: 3, noNaN: true });
/** Pieces are single precision: 2⁻²³ of coordinates up to 5. */
const tolerance = 1e-6;

const difference = (ends: ArrayLike<number>) => [0, 1, 2].map((c) => ends[c] - ends[3 + c]);
const middle = (ends: ArrayLike<number>) => [0, 1, 2].map((c) => (ends[c] + ends[3 + c]) / 2);
const length = (vector: number[]) => Math.hypot(...vector);

/** The projection d = r (p_i − p_j)/‖p_i − p_j‖; any direction when collapsed. */
function projection(p: Float64Array, r: number): Float64Array {
  const x = difference(p);
  return Float64Array.from(
    length(x) > 0 ? x.map((c) => r * (c / length(x))) /* in this order: r c may underflow */ : [r, 0, 0],
  );
}

/** Both ends of the piece, #6. */
function piece(p: Float64Array, r: number, exaggeration: number, tear: number): Float32Array {
  const pieces = new Float32Array(4);
  writePieces(p, E, Float64Array.of(r), { d: projection(p, r), exaggeration, tear }, 1, pieces);
  return pieceEnds(p, E, pieces);
}

describe('a piece', () => {
  it('that is a true projection is as long as at rest, about the midpoint of its own spring', () => {
    fc.assert(
      fc.property(points, restLength, (p, r) => {
        const ends = piece(p, r, 1, 1);
        expect(Math.abs(length(difference(ends)) - r)).toBeLessThan(4 * tolerance);
        for (let c = 0; c < 3; c++) expect(Math.abs(middle(ends)[c] - middle(p)[c])).toBeLessThan(tolerance);
      }),
    );
  });

  it('is before the tear the spring itself, whatever the exaggeration', () => {
    fc.assert(
      fc.property(points, restLength, fc.double({ min: 1, max: 1000, noNaN: true }), (p, r, x) => {
        const ends = piece(p, r, x, 0);
        for (let c = 0; c < 6; c++) expect(Math.abs(ends[c] - p[c])).toBeLessThan(tolerance);
      }),
    );
  });

  it('of a spring of 2 m at rest at 1 m, half torn, is 1.5 m long', () => {
    expect([...piece(Float64Array.of(2, 0, 0, 0, 0, 0), 1, 1, 0.5)]).toEqual([1.75, 0, 0, 0.25, 0, 0]);
  });

  it('of a collapsed spring opens along its projection', () => {
    expect([...piece(Float64Array.of(1, 1, 1, 1, 1, 1), 2, 1, 1)]).toEqual([2, 1, 1, 0, 1, 1]);
  });

  it('of no rest length shrinks to its midpoint', () => {
    expect([...piece(Float64Array.of(1, 0, 0, 3, 0, 0), 0, 1, 1)]).toEqual([2, 0, 0, 2, 0, 0]);
  });
});

it('without projections every piece is its whole spring', () => {
  const p = Float64Array.of(0, 0, 0, 1, 2, 3, 4, 5, 6);
  const springs = Int32Array.of(2, 0, 1, 2);
  const pieces = new Float32Array(8);
  writePieces(p, springs, Float64Array.of(1, 1), null, 1, pieces);
  expect([...springEnds(p, springs)]).toEqual([4, 5, 6, 0, 0, 0, 1, 2, 3, 4, 5, 6]);
  expect(pieceEnds(p, springs, pieces)).toEqual(springEnds(p, springs));
});

it('a piece carries its strain as a share of the range, and no more than all of it', () => {
  const colourOf = (l: number, r: number) => {
    const pieces = new Float32Array(4);
    writePieces(Float64Array.of(l, 0, 0, 0, 0, 0), E, Float64Array.of(r), null, 0.5, pieces);
    return pieces[3];
  };
  // Stretched by a quarter, squeezed by an eighth, by far too much, and without end.
  expect([colourOf(5, 4), colourOf(7, 8), colourOf(1, 8), colourOf(1, 0)]).toEqual([0.5, -0.25, -1, 1]);
});

describe('pieceLength', () => {
  it('exaggerates the difference to the rest length', () => {
    expect(pieceLength(1, 0.99, 10)).toBeCloseTo(0.9, 12);
    expect(pieceLength(1, 1.01, 10)).toBeCloseTo(1.1, 12);
  });

  it('never turns a piece inside out, nor lets it cross the view', () => {
    expect(pieceLength(1, 0.5, 1000)).toBe(0.2);
    expect(pieceLength(1, 1.5, 1000)).toBe(2);
  });

  it('is the rest length without exaggeration, however far that is', () => {
    fc.assert(
      fc.property(restLength, restLength, (l, r) => {
        expect(pieceLength(l, r, 1)).toBeCloseTo(r, 12);
      }),
    );
  });
});

it('strain: a spring of 3 m at rest at 2 m is stretched by a half; of no length at rest, without end', () => {
  expect(strain(3, 2)).toBe(0.5);
  expect(strain(3, 0)).toBe(Number.POSITIVE_INFINITY);
  expect(strain(0, 0)).toBe(0);
});
