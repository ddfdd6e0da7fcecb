import { describe, expect, it } from 'vitest';
import { lowestVertices } from '../../../web/src/scene/lowest_vertices.ts';

describe('lowestVertices', () => {
  it('takes all within 3 % of the height from the lowest, whatever the other coordinates', () => {
    const heights = [2, -1, -0.92, -0.9, -1]; // 3 m high: up to −0.91 m
    const V = Float64Array.from(heights.flatMap((y, i) => [-9 * i, y, 9]));
    expect(lowestVertices(V)).toEqual([1, 2, 4]);
  });

  it('takes all of what is level', () => {
    expect(lowestVertices(Float64Array.of(0, 1, 0, 5, 1, 0))).toEqual([0, 1]);
  });
});
