import { Ray, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { Poking } from '../../../../web/src/views/scene3d/poking.ts';

/** A tetrahedron of springs with a vertex in its middle, which nobody sees. Its diagonal is √12 m. */
const V = Float64Array.of(0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 0.25, 0.25, 0.25);
const E = Int32Array.of(0, 1, 0, 2, 0, 3, 1, 2, 1, 3, 2, 3, 4, 0, 4, 1, 4, 2, 4, 3);
const F = Uint32Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);
const solid = new Poking({ V, E, F });
const net = new Poking({ V, E, F: new Uint32Array() });
const none = new Int32Array();

describe('Poking', () => {
  it('takes hold of what lies inside, too, where it is now', () => {
    const moved = V.map((value) => value + 1);
    const grip = solid.grip(solid.onVertex(0, moved), moved, none, 0.5);
    expect([...(grip?.vertices ?? [])]).toEqual([0, 4]);
    expect([...(grip?.from ?? [])]).toEqual([1, 1, 1, 1.25, 1.25, 1.25]);
  });

  it('reaches as far as 8 % of the diagonal unless told', () => {
    const near = V.slice();
    near[12] = 0.27; // 4 now lies at (0.27, 0, 0), within 0.08·√12 = 0.277 m of 0
    near[13] = near[14] = 0;
    expect(solid.grip(solid.onVertex(0, near), near, none, null)?.vertices.length).toBe(2);
    near[12] = 0.28;
    expect(solid.grip(solid.onVertex(0, near), near, none, null)?.vertices.length).toBe(1);
  });

  it('takes hold of nothing where all is fixed', () => {
    expect(solid.grip(solid.onVertex(1, V), V, Int32Array.of(1), 0.5)).toBeNull();
  });

  it('without a surface takes the point of a spring that is nearest to the ray', () => {
    const ray = new Ray(new Vector3(0.5, 3, 1), new Vector3(0, -1, 0));
    expect(net.onSpring(0, ray, V)).toEqual({ point: new Vector3(0.5, 0, 0), corners: [0, 1] });
  });

  it('chooses among the vertices that are seen', () => {
    expect(solid.neighboursOf(0).sort()).toEqual([1, 2, 3]);
    expect(net.neighboursOf(0).sort()).toEqual([1, 2, 3, 4]);
    expect(solid.first(none)).toBe(2);
    expect(solid.first(Int32Array.of(0, 1, 2, 3))).toBeNull();
    expect(net.first(Int32Array.of(0, 1, 2, 3))).toBe(4);
  });

  it('hides what lies inside of a solid or behind it, and nothing else', () => {
    const fromAbove = new Ray(new Vector3(0.1, 5, 0.1), new Vector3(0, -1, 0));
    expect(solid.hides(new Vector3(0.1, 0, 0.1), fromAbove, V)).toBe(true);
    expect(solid.hides(new Vector3(0.1, 1.8, 0.1), fromAbove, V)).toBe(false); // on the surface
    expect(net.hides(new Vector3(0.1, 0, 0.1), fromAbove, V)).toBe(false);
  });
});
