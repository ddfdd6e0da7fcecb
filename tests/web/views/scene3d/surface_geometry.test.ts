import { describe, expect, it } from 'vitest';
import { surfaceCorners, takeRows, vertexNormals } from '../../../../web/src/views/scene3d/surface_geometry.ts';

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

describe('vertexNormals', () => {
  const normalsOf = (p: number[], faces: Uint32Array) => {
    const out = new Float32Array(p.length).fill(9);
    vertexNormals(Float64Array.from(p), faces, out);
    return out;
  };

  it('of a flat sheet all point the same way, counter-clockwise from the front', () => {
    const normals = normalsOf([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0], F);
    for (let v = 0; v < 4; v++) expect([...normals.subarray(3 * v, 3 * v + 3)]).toEqual([0, 0, 1]);
  });

  it('at a fold larger triangles weigh more', () => {
    // One triangle of area ½ facing +z, one of area 1 facing +x, both at vertex 0.
    const normals = normalsOf([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2], Uint32Array.of(0, 1, 2, 0, 2, 3));
    expect(normals[0]).toBeCloseTo(2 / Math.sqrt(5), 6);
    expect(normals[2]).toBeCloseTo(1 / Math.sqrt(5), 6);
  });

  it('a vertex without triangles has none, and no NaN', () => {
    expect([...normalsOf([0, 0, 0], new Uint32Array())]).toEqual([0, 0, 0]);
  });
});

it('takeRows copies the chosen rows, in order, some of them twice', () => {
  const out = new Float32Array(9);
  takeRows(Float64Array.of(0, 1, 2, 3, 4, 5), Int32Array.of(1, 0, 1), out);
  expect([...out]).toEqual([3, 4, 5, 0, 1, 2, 3, 4, 5]);
});
