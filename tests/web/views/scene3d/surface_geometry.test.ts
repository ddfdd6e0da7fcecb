import { describe, expect, it } from 'vitest';
import { encloses, surfaceCorners, trianglesAround } from '../../../../web/src/views/scene3d/surface_geometry.ts';

/** Two triangles that share the edge 1–2. */
const F = Uint32Array.of(0, 1, 2, 2, 1, 3);

describe('surfaceCorners', () => {
  it('without a texture, corners are vertices', () => {
    const { vertices, triangles } = surfaceCorners(F, null);
    expect(vertices.length).toBe(4);
    expect([...triangles].map((corner) => vertices[corner])).toEqual([...F]);
  });

  it('along a seam each side has corners of its own', () => {
    const texture = {
      url: '',
      VT: Float32Array.from({ length: 12 }, (_, at) => at),
      FT: Uint32Array.of(0, 1, 2, 4, 5, 3),
    };
    const { vertices, uvs, triangles } = surfaceCorners(F, texture);
    expect(vertices.length).toBe(6);
    triangles.forEach((corner, at) => {
      expect(vertices[corner]).toBe(F[at]);
      expect([...uvs.subarray(2 * corner, 2 * corner + 2)]).toEqual([2 * texture.FT[at], 2 * texture.FT[at] + 1]);
    });
  });
});

describe('encloses', () => {
  it('is true of a tetrahedron and false when a side is missing', () => {
    const sides = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
    expect(encloses(Uint32Array.from(sides))).toBe(true);
    expect(encloses(Uint32Array.from(sides.slice(3)))).toBe(false);
    expect(encloses(new Uint32Array())).toBe(false);
  });
});

describe('trianglesAround', () => {
  const { fans, others } = trianglesAround(F, 5);
  /** The triangles around a vertex, each from it on. */
  const fan = (v: number) => {
    const around: number[][] = [];
    for (let at = fans[2 * v]; at < fans[2 * v + 1]; at++) around.push([v, others[2 * at], others[2 * at + 1]]);
    return around;
  };

  it('finds them in the order of their corners, by which they know their front', () => {
    expect([0, 1, 2, 3].map(fan)).toEqual([
      [[0, 1, 2]],
      [
        [1, 2, 0],
        [1, 3, 2],
      ],
      [
        [2, 0, 1],
        [2, 1, 3],
      ],
      [[3, 2, 1]],
    ]);
  });

  it('and none around a vertex that is only in springs', () => {
    expect(fan(4)).toEqual([]);
  });
});
