import { describe, expect, it } from 'vitest';
import { arrowTip, pullBy, pullOn } from '../../../../web/src/views/scene3d/pull.ts';

const vertices = Int32Array.of(2, 0);
const grip = { vertices, from: Float64Array.of(1, 0, 0, 3, 0, 0) };

describe('pullBy', () => {
  it('pulls each vertex to where it was, moved by the same vector', () => {
    const pull = pullBy(grip, [0, 0.5, -1], 100);
    expect(pull).toEqual({ vertices, targets: Float64Array.of(1, 0.5, -1, 3, 0.5, -1), stiffness: 100 });
  });
});

describe('pullOn', () => {
  const points = Float64Array.of(3, 0, 0, 9, 9, 9, 1, 0, 0);

  it('is the sum of all springs, from the middle of the vertices to the handle', () => {
    const { centre, handle, force } = pullOn(pullBy(grip, [0, 0.5, 0], 100), points);
    expect([...centre]).toEqual([2, 0, 0]);
    expect([...handle]).toEqual([2, 0.5, 0]);
    expect(force).toBe(2 * 100 * 0.5);
  });

  it('is nothing when all are where they are pulled to', () => {
    expect(pullOn(pullBy(grip, [0, 0, 0], 100), points).force).toBe(0);
  });
});

describe('arrowTip', () => {
  /** Metres along y, at 100 pixels a metre. */
  const lengthOf = (metres: number) =>
    arrowTip({ centre: Float64Array.of(1, 2, 3), handle: Float64Array.of(1, 2 + metres, 3) }, 100)[1] - 2;

  it('is the handle as soon as that is 32 pixels away', () => {
    expect(lengthOf(0.5)).toBe(0.5);
    expect(lengthOf(-4)).toBe(-4);
  });

  it('lies 32 pixels towards it when it is nearer, and in the middle when nothing pulls', () => {
    // Differences of numbers near 2 have 15 digits.
    expect(lengthOf(0.02)).toBeCloseTo(0.32, 14);
    expect(lengthOf(-0.01)).toBeCloseTo(-0.32, 14);
    expect(lengthOf(0.005)).toBeCloseTo(0.16, 14); // half a pixel
    expect(lengthOf(0)).toBe(0);
  });
});
