import { Ray, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { surfaceHit } from '../../../../web/src/views/scene3d/surface_hit.ts';

/** Two triangles over one another, at z = 0 and z = 1; the upper one comes last. */
const F = Uint32Array.of(0, 1, 2, 3, 5, 4);
const points = Float64Array.of(0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 1, 2, 0, 1, 0, 2, 1);
const along = (x: number, y: number, z: number, down: -1 | 1) => new Ray(new Vector3(x, y, z), new Vector3(0, 0, down));

describe('surfaceHit', () => {
  it('meets the triangle that lies in front, from either side', () => {
    expect(surfaceHit(along(0.5, 0.5, 5, -1), F, points)).toEqual({
      point: new Vector3(0.5, 0.5, 1),
      corners: [3, 5, 4],
    });
    expect(surfaceHit(along(0.5, 0.5, -5, 1), F, points)).toEqual({
      point: new Vector3(0.5, 0.5, 0),
      corners: [0, 1, 2],
    });
  });

  it('meets nothing behind the eye, nor beside the triangles', () => {
    expect(surfaceHit(along(0.5, 0.5, 0.5, -1), F, points)?.corners).toEqual([0, 1, 2]);
    expect(surfaceHit(along(0.5, 0.5, -1, -1), F, points)).toBeNull();
    expect(surfaceHit(along(1.5, 1.5, 5, -1), F, points)).toBeNull();
  });

  it('looks where the vertices are now', () => {
    const moved = points.map((value, at) => (at % 3 === 0 ? value + 10 : value));
    expect(surfaceHit(along(0.5, 0.5, 5, -1), F, moved)).toBeNull();
    expect(surfaceHit(along(10.5, 0.5, 5, -1), F, moved)?.point).toEqual(new Vector3(10.5, 0.5, 1));
  });
});
