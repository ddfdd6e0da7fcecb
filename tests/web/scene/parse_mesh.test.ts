import { describe, expect, it } from 'vitest';
import type { Geometry } from '../../../web/src/scene/geometry.ts';
import { parseMesh } from '../../../web/src/scene/parse_mesh.ts';
import { describeSceneError, isSceneError } from '../../../web/src/scene/scene_error.ts';

const head = 'MeshVersionFormatted 2\nDimension 3\n';
// Of the unit cube: the corner at the origin, cut off, and a second tetrahedron from that cut to the opposite corner.
const vertices = 'Vertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\n';
const twoTetrahedra = `${head}${vertices}Tetrahedra\n2\n1 2 3 4 0\n2 3 4 5 0\nEnd\n`;

function parsed(text: string): Geometry {
  const result = parseMesh('a.mesh', text);
  if (isSceneError(result)) throw new Error(describeSceneError(result));
  return result;
}

describe('parseMesh', () => {
  it('takes each edge of the tetrahedra once as a spring, and the faces of one tetrahedron alone as the surface', () => {
    const { V, E, F, T } = parsed(twoTetrahedra);
    expect([...V]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1]);
    expect([...T]).toEqual([0, 1, 2, 3, 1, 2, 3, 4]);
    // Six edges of the first, and of the second the three that end in vertex 4.
    expect([...E]).toEqual([0, 1, 0, 2, 0, 3, 1, 2, 1, 3, 2, 3, 1, 4, 2, 4, 3, 4]);
    // Face 1 2 3 lies between the two. Both tetrahedra have positive volume: their corners' order stands.
    expect([...F]).toEqual([0, 3, 2, 0, 1, 3, 0, 2, 1, 2, 3, 4, 1, 4, 3, 1, 2, 4]);
  });

  it('reads the same whatever the white space, with comments, and without a section after End', () => {
    const words = twoTetrahedra.trim().split(/\s+/);
    const { V, E, F } = parsed(`# a solid\r\n\r\n  ${words.join('\r\n\t')} # the end\nEdges 1 1 1 0`);
    const same = parsed(twoTetrahedra);
    expect([V, E, F]).toEqual([same.V, same.E, same.F]);
    expect(parsed(words.join(' ')).E).toEqual(same.E);
  });

  it('skips sections that scenes do not use, and reads elements above their vertices', () => {
    const { E } = parsed(`${head}Corners\n2\n1\n2\nEdges 1\n1 5 7\nNormals 1 0 0 1\nRequiredVertices 0\n${vertices}`);
    expect([...E]).toEqual([0, 4]);
  });

  it('takes triangles of a mesh without tetrahedra as they are, and among tetrahedra those that are no face of one', () => {
    const shell = parsed(`${head}${vertices}Triangles 2 1 2 3 0 3 2 4 0`);
    expect([...shell.F]).toEqual([0, 1, 2, 2, 1, 3]);
    expect([...shell.E]).toEqual([0, 1, 0, 2, 1, 2, 2, 3, 1, 3]);
    const { F } = parsed(`${head}${vertices}Tetrahedra 1 1 2 3 4 0 Triangles 2 2 1 3 0 2 3 5 0`);
    expect([...F.slice(12)]).toEqual([1, 2, 4]);
  });

  it.each([
    ['', 'a.mesh: does not begin with MeshVersionFormatted, as a Medit mesh in text form does'],
    ['v 0 0 0', 'a.mesh: does not begin with MeshVersionFormatted, as a Medit mesh in text form does'],
    ['MeshVersionFormatted 1\nDimension\n2\n', 'a.mesh line 3: Dimension is 2 instead of 3'],
    [`${head}Vertices\nx`, 'a.mesh line 4: x is not a whole number'],
    [`${head}Vertices\n-1`, 'a.mesh line 4: -1 is not a whole number'],
    [`${head}Vertices\n2\n0 0 0 0\nTetrahedra`, 'a.mesh line 6: Vertices ends after 1 of 2 rows'],
    [`${head}Vertices\n2\n0 0 0 0`, 'a.mesh line 5: Vertices ends after 1 of 2 rows'],
    [`${head}Vertices\n1\n0 y 0 0`, 'a.mesh line 5: y is not a finite number'],
    [`${head}Vertices\n1\n0 1e999 0 0`, 'a.mesh line 5: 1e999 is not a finite number'],
    [`${head}${vertices}7 7 7 0`, 'a.mesh line 10: 7 stands where the name of a section should'],
    [`${head}${vertices}Edges 1\n1 2.5 0`, 'a.mesh line 11: 2.5 is not a vertex number'],
    [`${head}${vertices}Edges 1\n0 1 0`, 'a.mesh line 11: 0 is not a vertex number'],
    [`${head}${vertices}Tetrahedra 1\n1 2 3 6 0`, 'a.mesh line 11: vertex 6 of 5'],
    [`${head}${vertices}Tetrahedra 2\n1 2 3 4 0\n1 2 3 2 0`, 'a.mesh line 12: vertex 2 is joined to itself'],
    [`${head}End`, 'a.mesh: there are no vertices'],
    [`${head}${vertices}End`, 'a.mesh: there are no springs'],
    [`${head}Vertices 100001${'\n0 0 0 0'.repeat(100_001)}`, 'a.mesh: 100001 vertices are more than 100000'],
  ])('refuses %.60j', (text, sentence) => {
    const result = parseMesh('a.mesh', text);
    expect(isSceneError(result) && describeSceneError(result)).toBe(sentence);
  });

  it('refuses more springs than it may keep', () => {
    const count = 1001; // every two of them: 500,500
    const pairs = Array.from({ length: count }, (_, j) =>
      Array.from({ length: j }, (_, i) => `${i + 1} ${j + 1} 0`),
    ).flat();
    const text = `${head}Vertices ${count}${'\n0 0 0 0'.repeat(count)}\nEdges ${pairs.length}\n${pairs.join('\n')}`;
    expect(parseMesh('a.mesh', text)).toMatchObject({ code: 'too_many_springs', params: { maximum: 500_000 } });
  });
});
