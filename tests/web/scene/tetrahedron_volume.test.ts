import { describe, expect, it } from 'vitest';
import { tetrahedronVolume } from '../../../web/src/scene/tetrahedron_volume.ts';

describe('tetrahedronVolume', () => {
  it('is a sixth of the cube, with the sign of the order', () => {
    const V = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
    expect(tetrahedronVolume(V, Uint32Array.of(0, 1, 2, 3))).toBe(1 / 6);
    expect(tetrahedronVolume(V, Uint32Array.of(1, 0, 2, 3))).toBe(-1 / 6);
  });
});
