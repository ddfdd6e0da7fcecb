import { describe, expect, it } from 'vitest';
import { pullBy, pullOn } from '../../../../web/src/views/scene3d/pull.ts';

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
