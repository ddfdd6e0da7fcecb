import { describe, expect, it } from 'vitest';
import { cholesky } from '../../../../../../web/src/labs/lesson/sections/solving/cholesky.ts';
import {
  assembled,
  movesByInsertion,
  type Triplet,
  tripletsOfQ,
  withZeros,
} from '../../../../../../web/src/labs/lesson/sections/sparse/assembly.ts';
import { farthest, globalStepWith } from '../../../../../../web/src/labs/lesson/sections/sparse/global_step_with.ts';
import type { Parameters } from '../../../../../../web/src/solver/module.ts';
import { sceneParameters } from '../../../../../../web/src/solver/scene_parameters.ts';
import { dense } from '../../../../../support/dense.ts';
import { openScene } from '../../../../../support/open_scene.ts';
import { expectOk, openSimulation } from '../../../../../support/open_simulation.ts';

const square = await openScene('square');
const n = 4;
const parametersWith = (k: number): Parameters => ({ ...sceneParameters(square), k, w: 1000, path: 'plain' });
const tripletsWith = (k: number) => tripletsOfQ(square, square.pinned, parametersWith(k));
const Qs = (k: number) => ({
  adding: withZeros(assembled(n, tripletsWith(k), 'add')),
  overwriting: withZeros(assembled(n, tripletsWith(k), 'overwrite')),
});

describe('the triplets of Q', () => {
  it("add up to the solver's matrix, and to nothing where no spring is", () => {
    const simulation = openSimulation(square, parametersWith(100));
    expect(Qs(100).adding).toEqual(dense(simulation.Q()));
    expect(assembled(n, tripletsWith(100), 'add')[0][2]).toBeNull();
  });

  it('are four for a spring, one for a mass, one for a pin', () => {
    expect(tripletsWith(100)).toHaveLength(4 * 4 + 4 + 2);
  });
});

describe('overwriting instead of adding, as the lesson claims', () => {
  it('leaves the diagonal with its last triplet only', () => {
    // Vertices 0 and 1 keep their pin, w = 1000 N/m; 2 and 3 their mass, 0.5 kg · (30/s)² = 450 N/m.
    expect(Qs(100).overwriting.map((row, i) => row[i])).toEqual([1000, 1000, 450, 450]);
  });

  it('pushes the net away from the origin, by more than a metre', () => {
    const simulation = openSimulation(square, parametersWith(100));
    expectOk(simulation.seek(2));
    const equations = Array.from({ length: n }, (_, vertex) => ({ vertex, ...simulation.probe_vertex(vertex) }));
    const step = globalStepWith(Qs(100).overwriting, { equations });
    const right = globalStepWith(Qs(100).adding, { equations });
    if (!('p' in step && 'p' in right)) throw new Error('both are positive definite');
    // Metres: positions of about 1 m, rounded a few times.
    expect(farthest(right.p, simulation.p())).toBeLessThan(1e-14);
    expect(farthest(step.p, right.p)).toBeGreaterThan(0.3);
    expect(Math.hypot(...step.p)).toBeGreaterThan(Math.hypot(...right.p));
  });

  it('has no triangle at all with stiff springs', () => {
    expect(cholesky(Qs(2000).overwriting)).toHaveProperty('failedAt');
    expect(cholesky(Qs(2000).adding)).toHaveProperty('L');
  });
});

describe('movesByInsertion', () => {
  const at = (...places: [number, number][]) => places.map(([i, j]): Pick<Triplet, 'i' | 'j'> => ({ i, j }));

  it('counts what stands behind each new entry', () => {
    expect(movesByInsertion(3, at([0, 0], [1, 1], [2, 2]))).toBe(0);
    expect(movesByInsertion(3, at([2, 2], [1, 1], [0, 0]))).toBe(0 + 1 + 2);
  });

  it('moves nothing for a place that is there already', () => {
    expect(movesByInsertion(3, at([1, 1], [2, 2], [1, 1]))).toBe(0);
  });

  it('comes near half the square of the number of entries when the flag is inserted backwards', async () => {
    const flag = await openScene('flag');
    const triplets = tripletsOfQ(flag, flag.pinned, sceneParameters(flag));
    const entries = flag.m.length + flag.E.length; // 2#E off the diagonal
    const moves = [triplets, [...triplets].reverse()].map((order) => movesByInsertion(flag.m.length, order));
    expect(moves[0]).toBeGreaterThan(50 * entries);
    expect(moves[1]).toBeGreaterThan(0.4 * entries ** 2);
  });
});
