import type { Scene } from '../../web/src/scene/scene.ts';
import type { Parameters, SolverModule } from '../../web/src/solver/module.ts';
import { milliseconds, typical } from './milliseconds.ts';
import { succeed } from './succeed.ts';
import type { TimedRun } from './timed_run.ts';

/** Runs time steps from rest in WebAssembly, in this Node. */
export function runModule(
  solver: SolverModule,
  { V, E, m, pinned }: Scene,
  parameters: Parameters,
  steps: number,
): TimedRun {
  const simulation = new solver.Simulation();
  try {
    const precompute = milliseconds(() => succeed(simulation.set_scene(V, E, m, pinned, parameters)));
    const stepTimes = Array.from({ length: steps }, () => milliseconds(() => succeed(simulation.step())));
    const p = simulation.p().slice();
    let { k } = parameters; // N/m
    const refactorise = typical(() => {
      k = k === parameters.k ? 2 * k : parameters.k;
      return milliseconds(() => succeed(simulation.set_parameters({ ...parameters, k })));
    });
    return { p, precompute, refactorise, stepTimes };
  } finally {
    simulation.delete();
  }
}
