import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { diagonal, screenAxes } from '../../../../web/src/views/scene3d/screen_axes.ts';

const dot = (a: number[], b: number[]) => a.reduce((sum, x, axis) => sum + x * b[axis], 0);
const coordinate = fc.double({ min: -10, max: 10, noNaN: true });

describe('screenAxes', () => {
  it('are x and y for a camera that looks along −z', () => {
    const { right, up } = screenAxes({ position: [0, 0, 5], target: [0, 0, 0] });
    expect(right.map((x) => x + 0)).toEqual([1, 0, 0]); // −0 is 0
    expect(up.map((x) => x + 0)).toEqual([0, 1, 0]);
  });

  it('are orthonormal, across the line of sight, and right is level', () => {
    fc.assert(
      fc.property(coordinate, coordinate, coordinate, (x, y, z) => {
        fc.pre(Math.hypot(x, z) > 0.1); // straight up and down there is no right
        const { right, up } = screenAxes({ position: [x, y, z], target: [0, 0, 0] });
        // 1e-12: a few roundings of numbers of size 1, divided by at least 0.1 / 17
        for (const [product, exact] of [
          [dot(right, right), 1],
          [dot(up, up), 1],
          [dot(right, up), 0],
          [dot(right, [x, y, z]) / 17, 0],
          [dot(up, [x, y, z]) / 17, 0],
          [right[1], 0],
        ])
          expect(Math.abs(product - exact)).toBeLessThan(1e-12);
        expect(up[1]).toBeGreaterThan(0);
      }),
    );
  });
});

describe('diagonal', () => {
  it('is that of the box around the points', () => {
    expect(diagonal(Float64Array.of(0, 0, 0, 3, -4, 0, 1, 0, 12))).toBe(13);
  });
});
