import { expect, it } from 'vitest';
import { Neighbours, trianglesEdges } from '../../../../web/src/views/scene3d/neighbours.ts';

it('knows of each vertex all that it is joined to, whichever end of an edge it is', () => {
  const neighbours = new Neighbours([0, 1, 2, 1, 1, 3], 5);
  expect([0, 1, 2, 3, 4].map((v) => [...neighbours.of(v)])).toEqual([[1], [0, 2, 3], [1], [1], []]);
});

it('triangles are joined along their three sides', () => {
  const edges = [...trianglesEdges(Uint32Array.of(0, 1, 2, 2, 1, 3))];
  expect(edges).toEqual([0, 1, 1, 2, 2, 0, 2, 1, 1, 3, 3, 2]);
});
