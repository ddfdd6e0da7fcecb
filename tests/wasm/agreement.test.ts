import { beforeAll, expect, test } from 'vitest';
import { runScene } from '../../web/headless/run_scene.ts';
import { sceneParameters } from '../../web/src/solver/scene_parameters.ts';
import { buildReference, runReference } from '../bench/native_reference.ts';
import { openScene } from '../support/open_scene.ts';
import { distance, solver } from '../support/open_simulation.ts';
import { positionsTolerance } from '../support/positions_tolerance.ts';

const steps = 3;

beforeAll(buildReference, 120_000); // compiles Eigen on a fresh machine

test('the module agrees with an independent native implementation on the flag', async () => {
  const flag = await openScene('flag');
  const parameters = sceneParameters(flag);
  const native = runReference('reference', flag, parameters, steps);
  for (const path of ['plain', 'fast'] as const) {
    const wasm = runScene(solver, flag, { ...parameters, path }, { steps, substeps: 1 });
    expect(distance(wasm.p, flag.V)).toBeGreaterThan(1e3 * positionsTolerance(flag)); // it moved
    expect(distance(wasm.p, native.p)).toBeLessThan(positionsTolerance(flag));
  }
});

test('dense and sparse agree on the tower', async () => {
  const tower = await openScene('tower');
  const [sparse, dense] = (['sparse', 'dense'] as const).map((storage) =>
    runScene(solver, tower, { ...sceneParameters(tower), path: 'plain', storage }, { steps, substeps: 1 }),
  );
  expect(distance(dense.p, sparse.p)).toBeLessThan(positionsTolerance(tower));
});
