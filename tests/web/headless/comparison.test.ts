import { join } from 'node:path';
import { expect, onTestFinished, test } from 'vitest';
import { folderSource } from '../../../web/headless/folder_source.ts';
import { loadSolver } from '../../../web/headless/load_solver.ts';
import { runScene } from '../../../web/headless/run_scene.ts';
import { loadScene } from '../../../web/src/scene/load_scene.ts';
import type { Scene } from '../../../web/src/scene/scene.ts';
import { isSceneError } from '../../../web/src/scene/scene_error.ts';
import { compareMethod } from '../../../web/src/solver/compare_method.ts';
import { minimisers, type Parameters } from '../../../web/src/solver/module.ts';
import { sceneParameters } from '../../../web/src/solver/scene_parameters.ts';

const solver = await loadSolver();

/** Time steps. */
const before = 4;

async function libraryScene(name: string): Promise<Scene> {
  const scene = await loadScene(`${name}.json`, folderSource(join(import.meta.dirname, '../../../scenes')));
  if (isSceneError(scene)) throw new Error(name);
  return scene;
}

/** A simulation of the scene at predict of the time step after those. */
function moving(scene: Scene, parameters: Parameters) {
  const simulation = new solver.Simulation();
  onTestFinished(() => simulation.delete());
  simulation.set_scene(scene.V, scene.E, scene.m, scene.pinned, parameters);
  for (let step = 0; step < before; step++) simulation.step();
  simulation.next_step();
  return simulation;
}

test.each(minimisers.flatMap((method) => [10, 50].map((iterations) => ({ method, iterations }))))(
  'simulate ends a time step where the comparison comes to in as many iterations: $method, $iterations',
  async ({ method, iterations }) => {
    const scene = await libraryScene('net');
    const parameters = { ...sceneParameters(scene), k: 1e4, method, iterations };
    const simulation = moving(scene, parameters);
    const start = simulation.objective_at(simulation.p().slice());
    const outcome = compareMethod(simulation, { method, iterations, patience_ms: Number.POSITIVE_INFINITY });
    if (!outcome.ok) throw new Error(outcome.status.code);
    const { change } = outcome.value;

    const { objective } = runScene(solver, scene, parameters, { steps: before + 1, substeps: 1 });
    const compared = start.objective + change[change.length - 1];
    // E is summed from about 200 terms no larger than its largest part, in two orders; the iterates of local and global step differ from those of
    // p ← p − Q⁻¹∇E by rounding times κ = 3e2, which E, flat near its minimum, feels less.
    const rounding = 1e3 * Number.EPSILON * Math.max(start.inertia, Math.abs(start.external), start.potential);
    expect(Math.abs(objective[before] - compared)).toBeLessThan(rounding);
  },
);
