import fc from 'fast-check';
import { expect, test } from 'vitest';
import { dense, rowSums } from '../support/dense.ts';
import { openMoving, openSimulation } from '../support/open_simulation.ts';
import { chain, movingScenes, net, usualParameters } from '../support/small_scenes.ts';

test('the matrices of a chain of three, by hand', () => {
  const simulation = openSimulation(chain(3), { ...usualParameters, k: 10, delta_t: 0.5, w: 100 });
  expect(dense(simulation.A())).toEqual([
    [1, -1, 0],
    [0, 1, -1],
  ]);
  expect(dense(simulation.M())).toEqual([
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ]);
  expect(dense(simulation.C())).toEqual([[1, 0, 0]]);
  expect(dense(simulation.Q())).toEqual([
    [10 + 4 + 100, -10, 0],
    [-10, 20 + 4, -10],
    [0, -10, 10 + 4],
  ]);
});

test('moving all vertices alike stretches no spring: A·1 = 0', () => {
  fc.assert(
    fc.property(movingScenes, (scene) => {
      expect(rowSums(openMoving(scene).A()).every((sum) => sum === 0)).toBe(true);
    }),
    { seed: 1, numRuns: 50 },
  );
});

test('Q is symmetric, and Q·1 = M/Δt² + w on the pins', () => {
  fc.assert(
    fc.property(movingScenes, (scene) => {
      const simulation = openMoving(scene);
      const Q = dense(simulation.Q());
      const { delta_t, w, k } = scene.parameters;
      rowSums(simulation.Q()).forEach((sum, i) => {
        const right = scene.m[i] / delta_t ** 2 + (scene.pinned.includes(i) ? w : 0);
        // A row is summed from up to ten entries of at most this size.
        expect(Math.abs(sum - right)).toBeLessThan(1e-14 * (right + 20 * k));
        for (let j = 0; j < i; j++) expect(Q[i][j]).toBe(Q[j][i]);
      });
    }),
    { seed: 2, numRuns: 50 },
  );
});

test('dense and sparse storage hold the same matrices', () => {
  const sparse = openSimulation(net(4), usualParameters);
  const full = openSimulation(net(4), { ...usualParameters, storage: 'dense' });
  for (const name of ['A', 'M', 'C', 'Q'] as const) expect(dense(full[name]())).toEqual(dense(sparse[name]()));
});
