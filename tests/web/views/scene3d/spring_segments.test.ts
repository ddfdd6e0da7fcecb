import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  pieceLength,
  pieceSegments,
  segmentStride,
  springSegments,
  springStrain,
} from '../../../../web/src/views/scene3d/spring_segments.ts';

const E = Int32Array.of(0, 1);
const coordinate = fc.double({ min: -2, max: 2, noNaN: true });
const points = fc.array(coordinate, { minLength: 6, maxLength: 6 }).map((row) => Float64Array.from(row));
const restLength = fc.double({ min: 0.01, max: 3, noNaN: true });
/** Segments are single precision: 2⁻²³ of coordinates up to 5. */
const tolerance = 1e-6;

const difference = (ends: ArrayLike<number>) => [0, 1, 2].map((c) => ends[c] - ends[3 + c]);
const middle = (ends: ArrayLike<number>) => [0, 1, 2].map((c) => (ends[c] + ends[3 + c]) / 2);
const length = (vector: number[]) => Math.hypot(...vector);

/** The projection d = r (p_i − p_j)/‖p_i − p_j‖; any direction when collapsed. */
function projection(p: Float64Array, r: number): Float64Array {
  const x = difference(p);
  return Float64Array.from(length(x) > 0 ? x.map((c) => (r * c) / length(x)) : [r, 0, 0]);
}

function piece(p: Float64Array, r: number, exaggeration: number, tear: number): Float32Array {
  const out = new Float32Array(segmentStride);
  pieceSegments(p, E, Float64Array.of(r), projection(p, r), exaggeration, tear, out);
  return endsOf(out);
}

/** Start and end of a row of segments, without what lies beside them. */
function endsOf(row: Float32Array): Float32Array {
  return Float32Array.of(...row.subarray(0, 3), ...row.subarray(4, 7));
}

describe('pieceSegments', () => {
  it('a true projection is as long as at rest, about the midpoint of its own spring', () => {
    fc.assert(
      fc.property(points, restLength, (p, r) => {
        const ends = piece(p, r, 1, 1);
        expect(Math.abs(length(difference(ends)) - r)).toBeLessThan(4 * tolerance);
        for (let c = 0; c < 3; c++) expect(Math.abs(middle(ends)[c] - middle(p)[c])).toBeLessThan(tolerance);
      }),
    );
  });

  it('before the tear it is the spring itself, whatever the exaggeration', () => {
    fc.assert(
      fc.property(points, restLength, fc.double({ min: 1, max: 1000, noNaN: true }), (p, r, x) => {
        const ends = piece(p, r, x, 0);
        for (let c = 0; c < 6; c++) expect(Math.abs(ends[c] - p[c])).toBeLessThan(tolerance);
      }),
    );
  });

  it('a spring of 2 m at rest at 1 m, half torn: 1.5 m', () => {
    expect([...piece(Float64Array.of(2, 0, 0, 0, 0, 0), 1, 1, 0.5)]).toEqual([1.75, 0, 0, 0.25, 0, 0]);
  });

  it('a collapsed spring opens along its projection', () => {
    expect([...piece(Float64Array.of(1, 1, 1, 1, 1, 1), 2, 1, 1)]).toEqual([2, 1, 1, 0, 1, 1]);
  });

  it('a spring of no rest length shrinks to its midpoint', () => {
    expect([...piece(Float64Array.of(1, 0, 0, 3, 0, 0), 0, 1, 1)]).toEqual([2, 0, 0, 2, 0, 0]);
  });
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

it('springSegments joins each spring’s two vertices, in order, and leaves its colour', () => {
  const p = Float64Array.of(0, 0, 0, 1, 2, 3, 4, 5, 6);
  const out = new Float32Array(2 * segmentStride).fill(9);
  springSegments(p, Int32Array.of(2, 0, 1, 2), out);
  expect([...out]).toEqual([4, 5, 6, 9, 0, 0, 0, 9, 1, 2, 3, 9, 4, 5, 6, 9]);
});

it('springStrain: a spring of 3 m at rest at 2 m is stretched by a half; of no length at rest, without end', () => {
  const p = Float64Array.of(3, 0, 0, 0, 0, 0);
  expect(springStrain(p, E, Float64Array.of(2), 0)).toBe(0.5);
  expect(springStrain(p, E, Float64Array.of(0), 0)).toBe(Number.POSITIVE_INFINITY);
  expect(springStrain(new Float64Array(6), E, Float64Array.of(0), 0)).toBe(0);
});
