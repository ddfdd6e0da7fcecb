import type { Scene } from '../src/scene/scene.ts';
import { describeStatus } from '../src/solver/describe_status.ts';
import type { Parameters, SolverModule, Status, StopReason } from '../src/solver/module.ts';
import { UsageError } from './usage_error.ts';

export interface Run {
  /** #V×3, m: positions at the end. */
  p: Float64Array;
  /** J: the objective of each time step, where the step ended. */
  objective: number[];
  /** Of each time step: how many iterations, and why no more. */
  iterationsMade: number[];
  stopReason: (StopReason | '')[];
  /** ms: setting the scene (factorisation included), and each step. */
  precompute: number;
  stepTimes: number[];
}

/** Runs time steps from rest. Throws UsageError with what the solver refuses. */
export function runScene(solver: SolverModule, scene: Scene, parameters: Parameters, steps: number): Run {
  const timed = (call: () => Status): number => {
    const start = performance.now();
    const status = call();
    const end = performance.now();
    if (status.code !== 'ok') throw new UsageError(`${scene.name}.json ${describeStatus(status)}`);
    return end - start;
  };
  const simulation = new solver.Simulation();
  try {
    const { V, E, m, pinned } = scene;
    const precompute = timed(() => simulation.set_scene(V, E, m, pinned, parameters));
    const objective: number[] = [];
    const iterationsMade: number[] = [];
    const stopReason: (StopReason | '')[] = [];
    const stepTimes: number[] = [];
    for (let step = 0; step < steps; step++) {
      stepTimes.push(timed(() => simulation.step()));
      objective.push(simulation.objective_at(simulation.p().slice()).objective);
      iterationsMade.push((simulation.last_half_step() - 1) / 2);
      stopReason.push(simulation.stop_reason());
    }
    return { p: simulation.p().slice(), objective, iterationsMade, stopReason, precompute, stepTimes };
  } finally {
    simulation.delete();
  }
}
