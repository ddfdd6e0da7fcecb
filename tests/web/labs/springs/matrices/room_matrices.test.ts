import { describe, expect, it } from 'vitest';
import { roomMatrices } from '../../../../../web/src/labs/springs/matrices/room_matrices.ts';
import { readElimination } from '../../../../../web/src/solver/eliminations.ts';
import type { Triplets } from '../../../../../web/src/solver/module.ts';
import { readLinearlyImplicit } from '../../../../../web/src/solver/read_linearly_implicit.ts';
import { readMatrices } from '../../../../../web/src/solver/read_matrices.ts';
import { entryAt } from '../../../../../web/src/views/sparsity/pattern.ts';
import type { SparsityModel } from '../../../../../web/src/views/sparsity/sparsity_view.tsx';
import { openSimulation } from '../../../../support/open_simulation.ts';
import { net, usualParameters } from '../../../../support/small_scenes.ts';

const scene = net(4);

/** The room's matrices of the net, and what the solver itself says of them. On the fast path pins are no unknowns. */
function opened() {
  const simulation = openSimulation(scene, { ...usualParameters, path: 'fast' });
  const matrices = readMatrices(simulation);
  const elimination = readElimination(simulation, 'solver');
  const implicit = readLinearlyImplicit(simulation);
  const { E, m, pinned } = scene;
  const models = roomMatrices(matrices, elimination, implicit, { E, vertexCount: m.length, pinned });
  const model = (name: keyof typeof models) => models[name] as SparsityModel;
  return { matrices, elimination, implicit, model };
}

function expectSame({ pattern }: SparsityModel, { rows, columns, i, j, value }: Triplets) {
  expect([pattern.rows, pattern.columns, pattern.value.length]).toEqual([rows, columns, value.length]);
  value.forEach((number, at) => {
    expect(pattern.value[entryAt(pattern, { row: i[at], column: j[at] })]).toBe(number);
  });
}

it('shows the solver’s own numbers', () => {
  const { matrices, elimination, implicit, model } = opened();
  for (const name of ['A', 'M', 'C', 'AtA', 'Q'] as const) expectSame(model(name), matrices[name]);
  expectSame(model('L'), elimination.factor as Triplets);
  expectSame(model('K'), implicit.K);
  expectSame(model('implicit'), implicit.system);
  expectSame(model('Phat'), implicit.P);
});

describe('links', () => {
  it('row e of A with spring e, its columns with vertices', () => {
    const { model } = opened();
    const A = model('A');
    const [spring, i, j] = [5, scene.E[10], scene.E[11]];
    expect(A.thingsAt({ row: spring, column: j })).toEqual({ spring, vertex: j });
    expect(A.marksOf({ spring, vertex: i })).toEqual({ rows: [spring], columns: [i], places: [] });
    expect(A.describe({ row: spring, column: i })).toBe(
      `row ${spring} (spring ${spring}), column ${i} (vertex ${i}): +1`,
    );
  });

  it('what is beside the diagonal of Q with the spring between, the diagonal with the vertex', () => {
    const { model } = opened();
    const Q = model('Q');
    const [spring, i, j] = [7, scene.E[14], scene.E[15]];
    expect(Q.thingsAt({ row: j, column: i })).toEqual({ spring, vertex: null });
    expect(Q.thingsAt({ row: i, column: i })).toEqual({ spring: null, vertex: i });
    const { places } = Q.marksOf({ spring, vertex: null });
    expect(places).toHaveLength(4);
    expect(places).toContainEqual({ row: j, column: i });
  });

  it('rows of C with pinned vertices, and rows and columns of L and P with the order of elimination', () => {
    const { elimination, model } = opened();
    const pin = scene.pinned[1];
    expect(model('C').thingsAt({ row: 1, column: pin })).toEqual({ spring: null, vertex: pin });
    const vertex = elimination.order[3];
    expect(model('L').thingsAt({ row: 3, column: 3 })).toEqual({ spring: null, vertex });
    expect(model('L').marksOf({ spring: null, vertex })).toEqual({ rows: [3], columns: [3], places: [] });
    expect(model('P').marksOf({ spring: null, vertex })).toEqual({ rows: [3], columns: [vertex], places: [] });
  });

  it('rows 3i, 3i + 1 and 3i + 2 of K with x, y and z of vertex i, blocks beside the diagonal with the spring between', () => {
    const { model } = opened();
    const K = model('K');
    const [spring, i, j] = [7, scene.E[14], scene.E[15]];
    expect(K.thingsAt({ row: 3 * j + 2, column: 3 * i })).toEqual({ spring, vertex: null });
    expect(K.thingsAt({ row: 3 * i, column: 3 * i + 1 })).toEqual({ spring: null, vertex: i });
    expect(K.marksOf({ spring: null, vertex: i }).rows).toEqual([3 * i, 3 * i + 1, 3 * i + 2]);
    const { places } = K.marksOf({ spring, vertex: null });
    expect(places).toHaveLength(36);
    expect(places).toContainEqual({ row: 3 * j + 2, column: 3 * i + 1 });
    expect(K.head('row', 3 * i + 1)).toBe(`${i}y`);
    expect(K.describe({ row: 3 * i + 1, column: 3 * i })).toContain(`row ${3 * i + 1} (vertex ${i}, y)`);
    expect(model('implicit').describe({ row: 1, column: 1 })).toMatch(/kg$/);
  });

  it('rows of P̂ with the coordinates of free vertices, none of a pinned one', () => {
    const { model } = opened();
    const P = model('Phat'); // vertex 0 is pinned: row 0 is x of vertex 1
    expect(P.thingsAt({ row: 0, column: 3 })).toEqual({ spring: null, vertex: 1 });
    expect(P.marksOf({ spring: null, vertex: 1 })).toEqual({ rows: [0, 1, 2], columns: [3, 4, 5], places: [] });
    expect(P.marksOf({ spring: null, vertex: 0 })).toEqual({ rows: [], columns: [0, 1, 2], places: [] });
    expect(P.describe({ row: 1, column: 4 })).toBe('row 1 (vertex 1, y), column 4 (vertex 1, y): +1');
  });

  it('a pinned vertex with nothing in L, which has no row for it', () => {
    const { model } = opened();
    expect(model('L').marksOf({ spring: null, vertex: scene.pinned[0] })).toEqual({
      rows: [],
      columns: [],
      places: [],
    });
  });
});
