import fc from 'fast-check';
import { expect, test } from 'vitest';
import type { Simulation } from '../../web/src/solver/module.ts';
import { dense } from '../support/dense.ts';
import { distance, expectOk, openMoving, openSimulation } from '../support/open_simulation.ts';
import { chain, type MovingScene, movingScenes, usualParameters } from '../support/small_scenes.ts';

const runs = { seed: 7, numRuns: 40 };

/** With dashpots in half of them. */
const scenes = fc
  .tuple(movingScenes, fc.constantFrom(0, 3))
  .map(([scene, damping]): MovingScene => ({ ...scene, parameters: { ...scene.parameters, damping } }));

/** Without the sign of a zero. */
const unsigned = (number: number) => number + 0;

const transposed = (matrix: number[][]) => (matrix[0] ?? []).map((_, j) => matrix.map((row) => row[j]));
const product = (a: number[][], b: number[][]) =>
  a.map((row) => (b[0] ?? []).map((_, j) => row.reduce((sum, entry, k) => sum + entry * b[k][j], 0)));
const largest = (matrix: number[][]) => matrix.flat().reduce((most, entry) => Math.max(most, Math.abs(entry)), 0);

/** The shares of the springs added up: −block at (i, i) and (j, j), +block at (i, j) and (j, i). */
function summed(simulation: Simulation, { E, m }: MovingScene, block: (e: number) => Float64Array): number[][] {
  const sum = m.reduce<number[][]>((rows) => {
    for (let c = 0; c < 3; c++) rows.push(new Array<number>(3 * m.length).fill(0));
    return rows;
  }, []);
  for (let e = 0; e < simulation.spring_count(); e++) {
    const share = block(e);
    for (const a of [0, 1])
      for (const b of [0, 1])
        share.forEach((entry, at) => {
          const [row, column] = [3 * E[2 * e + a] + Math.floor(at / 3), 3 * E[2 * e + b] + (at % 3)];
          sum[row][column] += a === b ? -entry : entry;
        });
  }
  return sum;
}

test('a stretched spring along x, by hand', () => {
  const scene = chain(2, 1);
  const simulation = openSimulation(scene, { ...usualParameters, k: 8, delta_t: 0.5, damping: 2, path: 'fast' });
  const stretched = Float64Array.of(0, 0, 0, 2, 0, 0); // l = 2, r = 1: k along x, k/2 across
  expectOk(simulation.set_state(1, stretched, stretched, 0));
  expect(Array.from(simulation.spring_stiffness(0), unsigned)).toEqual([8, 0, 0, 0, 4, 0, 0, 0, 4]);
  expect(Array.from(simulation.spring_resistance(0), unsigned)).toEqual([2, 0, 0, 0, 0, 0, 0, 0, 0]);
  const { K, P, system, constrained } = simulation.linearly_implicit_terms();
  expect(dense(K)[0]).toEqual([-8, 0, 0, 8, 0, 0]);
  expect(dense(K)[4]).toEqual([0, 4, 0, 0, -4, 0]);
  expect(dense(P)).toEqual([
    [0, 0, 0, 1, 0, 0],
    [0, 0, 0, 0, 1, 0],
    [0, 0, 0, 0, 0, 1],
  ]);
  // m + Δt C + Δt² k along the spring, m + Δt² k/2 across it.
  expect(dense(system)[3]).toEqual([-3, 0, 0, 4, 0, 0]);
  expect(dense(constrained)).toEqual([
    [4, 0, 0],
    [0, 2, 0],
    [0, 0, 2],
  ]);
});

test('K and P̂KP̂ᵀ are symmetric, P̂P̂ᵀ = I, and the shares of the springs add up to K and D', () => {
  fc.assert(
    fc.property(scenes, (scene) => {
      const simulation = openMoving(scene);
      const terms = simulation.linearly_implicit_terms();
      const [K, D, P] = [terms.K, terms.D, terms.P].map(dense);
      expect(K).toEqual(transposed(K));
      expect(D).toEqual(transposed(D));
      const PK = product(product(P, K), transposed(P));
      expect(PK).toEqual(transposed(PK));
      expect(product(P, transposed(P))).toEqual(P.map((_, i) => P.map((_, j) => (i === j ? 1 : 0))));
      // Up to nine springs at a vertex, added in another order.
      const tolerance = 1e-14 * (1 + largest(K) + largest(D));
      expect(distance(summed(simulation, scene, (e) => simulation.spring_stiffness(e)).flat(), K.flat())).toBeLessThan(
        tolerance,
      );
      expect(distance(summed(simulation, scene, (e) => simulation.spring_resistance(e)).flat(), D.flat())).toBeLessThan(
        tolerance,
      );
    }),
    runs,
  );
});

test('the matrix is M − Δt D − Δt² K, and P̂ (…) P̂ᵀ where vertices are pinned', () => {
  fc.assert(
    fc.property(scenes, (scene) => {
      const simulation = openMoving(scene);
      const terms = simulation.linearly_implicit_terms();
      const [K, D, P, system, constrained] = [terms.K, terms.D, terms.P, terms.system, terms.constrained].map(dense);
      const { delta_t } = scene.parameters;
      const expected = K.map((row, i) =>
        row.map((entry, j) => (i === j ? scene.m[Math.floor(i / 3)] : 0) - delta_t * D[i][j] - delta_t ** 2 * entry),
      );
      // Three summands, each rounded.
      expect(distance(system.flat(), expected.flat())).toBeLessThan(1e-14 * (1 + largest(expected)));
      // Every entry of the product is one entry of the matrix.
      expect(constrained).toEqual(product(product(P, system), transposed(P)).map((row) => row.map(unsigned)));
      expect(constrained).toHaveLength(3 * (scene.m.length - scene.pinned.length));
    }),
    runs,
  );
});

test('the matrices are of p^t until the time step is accepted, and then of p', () => {
  const simulation = openSimulation(chain(4), { ...usualParameters, path: 'fast' });
  const before = simulation.linearly_implicit_terms().K;
  expect(simulation.settled().slice()).toEqual(chain(4).V);
  expectOk(simulation.seek(2));
  expect(simulation.linearly_implicit_terms().K).toEqual(before);
  expectOk(simulation.step());
  expect(simulation.settled().slice()).toEqual(simulation.p().slice());
  expect(simulation.linearly_implicit_terms().K).not.toEqual(before);
});

test('there are no numbers where there is no spring', () => {
  const simulation = openSimulation(chain(3), usualParameters);
  for (const e of [-1, 2]) {
    expect([...simulation.spring_stiffness(e)]).toEqual(new Array(9).fill(Number.NaN));
    expect([...simulation.spring_resistance(e)]).toEqual(new Array(9).fill(Number.NaN));
  }
});
