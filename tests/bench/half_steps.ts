import type { Scene } from '../../web/src/scene/scene.ts';
import type { SolverModule } from '../../web/src/solver/module.ts';
import { benchParameters } from './bench_parameters.ts';
import { milliseconds, typical } from './milliseconds.ts';
import { succeed } from './succeed.ts';

/** ms of each half of an iteration on the fast path. */
export interface HalfSteps {
  /** ∂E/∂p from all springs. */
  local: number;
  /** Q⁻¹: both sweeps through L. */
  global: number;
}

export function halfSteps(solver: SolverModule, scene: Scene): HalfSteps {
  const parameters = benchParameters(scene);
  const { iterations } = parameters;
  const simulation = new solver.Simulation();
  try {
    succeed(simulation.set_scene(scene.V, scene.E, scene.m, scene.pinned, parameters));
    return {
      local: typical(() => milliseconds(() => simulation.rehearse_local_step(iterations))) / iterations,
      global: typical(() => milliseconds(() => simulation.rehearse_global_step(iterations))) / iterations,
    };
  } finally {
    simulation.delete();
  }
}
