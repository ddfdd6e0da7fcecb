import { describe, expect, it } from 'vitest';
import { roomMatrices } from '../../../../../web/src/labs/springs/matrices/room_matrices.ts';
import { readElimination } from '../../../../../web/src/solver/eliminations.ts';
import type { Triplets } from '../../../../../web/src/solver/module.ts';
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
  const { E, m, pinned } = scene;
  const models = roomMatrices(matrices, elimination, { E, vertexCount: m.length, pinned });
  const model = (name: keyof typeof models) => models[name] as SparsityModel;
  return { matrices, elimination, model };
}

function expectSame({ pattern }: SparsityModel, { rows, columns, i, j, value }: Triplets) {
  expect([pattern.rows, pattern.columns, pattern.value.length]).toEqual([rows, columns, value.length]);
  value.forEach((number, at) => {
    expect(pattern.value[entryAt(pattern, { row: i[at], column: j[at] })]).toBe(number);
  });
}

it('shows the solver’s own numbers', () => {
  const { matrices, elimination, model } = opened();
  for (const name of ['A', 'M', 'C', 'AtA', 'Q'] as const) expectSame(model(name), matrices[name]);
  expectSame(model('L'), elimination.factor as Triplets);
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

  it('a pinned vertex with nothing in L, which has no row for it', () => {
    const { model } = opened();
    expect(model('L').marksOf({ spring: null, vertex: scene.pinned[0] })).toEqual({
      rows: [],
      columns: [],
      places: [],
    });
  });
});
