import { describe, expect, it } from 'vitest';
import { nearestPoint, nearestSegment, tolerancesFor } from '../../../../web/src/views/scene3d/picking.ts';

describe('nearestPoint', () => {
  const points = Float32Array.of(0, 0, 10, 0, Number.NaN, Number.NaN);

  it('finds the nearest of those in reach', () => {
    expect(nearestPoint(points, 4, 0, 8)).toBe(0);
    expect(nearestPoint(points, 6, 0, 8)).toBe(1);
  });

  it('reaches as far as the tolerance and no farther', () => {
    expect(nearestPoint(points, 13, 4, 5)).toBe(1);
    expect(nearestPoint(points, 13, 4, 4.9)).toBeNull();
  });

  it('never finds what is behind the camera', () => {
    expect(nearestPoint(Float32Array.of(Number.NaN, Number.NaN), 0, 0, 1e9)).toBeNull();
  });
});

describe('nearestSegment', () => {
  const cross = Float32Array.of(0, 0, 10, 0, 5, 2, 5, 12);

  it('measures across the segment between its ends', () => {
    expect(nearestSegment(cross, 2, -3, 3)).toBe(0);
    expect(nearestSegment(cross, 2, -3, 2.9)).toBeNull();
  });

  it('measures to the end beyond it', () => {
    expect(nearestSegment(cross, 13, -4, 5)).toBe(0);
    expect(nearestSegment(cross, 13, -4, 4.9)).toBeNull();
  });

  it('takes the nearer of two', () => {
    expect(nearestSegment(cross, 5, 0.9, 6)).toBe(0);
    expect(nearestSegment(cross, 5, 1.1, 6)).toBe(1);
  });

  it('a segment seen from its end is a point', () => {
    expect(nearestSegment(Float32Array.of(3, 4, 3, 4), 0, 0, 5)).toBe(0);
  });
});

describe('tolerancesFor', () => {
  it('gives fingers and pens twice the reach of a mouse', () => {
    expect(tolerancesFor('touch', 100)).toEqual({ pin: 24, vertex: 20, spring: 12 });
    expect(tolerancesFor('mouse', 100)).toEqual({ pin: 12, vertex: 10, spring: 6 });
  });

  it('leaves the middle of short springs to the springs', () => {
    for (const length of [12, 20, 30]) expect(tolerancesFor('mouse', length).vertex).toBeLessThan(length / 2);
  });
});
