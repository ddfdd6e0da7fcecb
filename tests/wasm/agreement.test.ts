import { beforeAll, expect, test } from 'vitest';
import { loadSolver } from '../../web/headless/load_solver.ts';
import { runScene } from '../../web/headless/run_scene.ts';
import type { Scene } from '../../web/src/scene/scene.ts';
import { sceneParameters } from '../../web/src/solver/scene_parameters.ts';
import { buildReference, runReference } from '../bench/native_reference.ts';
import { openScene } from '../support/open_scene.ts';

const solver = await loadSolver();
const steps = 3;

/** m: 1e-7 of the diagonal of the bounding box. Leaves room for any order of summation: rounding makes about 1e-13 of it. */
function tolerance({ V }: Scene): number {
  const extent = [0, 1, 2].map((axis) => {
    const coordinates = V.filter((_, index) => index % 3 === axis);
    return coordinates.reduce((a, b) => Math.max(a, b)) - coordinates.reduce((a, b) => Math.min(a, b));
  });
  return 1e-7 * Math.hypot(...extent);
}

/** max over all coordinates, m. */
function distance(p: ArrayLike<number>, q: ArrayLike<number>): number {
  expect(p.length).toBe(q.length);
  return Array.from(p, (value, index) => Math.abs(value - q[index])).reduce((a, b) => Math.max(a, b));
}

beforeAll(buildReference, 120_000); // compiles Eigen on a fresh machine

test('the module agrees with an independent native implementation on the flag', async () => {
  const flag = await openScene('flag');
  const parameters = sceneParameters(flag);
  const native = runReference('reference', flag, parameters, steps);
  const wasm = runScene(solver, flag, parameters, steps);
  expect(distance(wasm.p, flag.V)).toBeGreaterThan(1e3 * tolerance(flag)); // it moved
  expect(distance(wasm.p, native.p)).toBeLessThan(tolerance(flag));
});

test('dense and sparse agree on the tower', async () => {
  const tower = await openScene('tower');
  const [sparse, dense] = (['sparse', 'dense'] as const).map((storage) =>
    runScene(solver, tower, { ...sceneParameters(tower), storage }, steps),
  );
  expect(distance(dense.p, sparse.p)).toBeLessThan(tolerance(tower));
});
