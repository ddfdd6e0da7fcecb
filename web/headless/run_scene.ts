import type { Scene } from '../src/scene/scene.ts';
import { describeStatus } from '../src/solver/describe_status.ts';
import type { Parameters, SolverModule, Status, StopReason } from '../src/solver/module.ts';
import { UsageError } from './usage_error.ts';

export interface Run {
  /** #V×3, m: positions at the end. */
  p: Float64Array;
  /** #V×3, m/s: velocities at the end. */
  velocity: Float64Array;
  /** J: the objective of each time step (of its last substep), where the step ended. */
  objective: number[];
  /** J: after each time step. Gravity's is 0 where y is. */
  energy: { kinetic: number; spring: number; gravity: number }[];
  /** Of each time step (of its last substep): how many iterations, and why no more. */
  iterationsMade: number[];
  stopReason: (StopReason | '')[];
  /** ms: setting the scene (factorisation included), and each step. */
  precompute: number;
  stepTimes: number[];
}

/** Runs time steps from rest, each of so many substeps. Throws UsageError with what the solver refuses. */
export function runScene(
  solver: SolverModule,
  scene: Scene,
  parameters: Parameters,
  { steps, substeps }: { steps: number; substeps: number },
): Run {
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
    const ofSubsteps = { ...parameters, delta_t: parameters.delta_t / substeps };
    const precompute = timed(() => simulation.set_scene(V, E, m, pinned, ofSubsteps));
    const objective: number[] = [];
    const energy: Run['energy'] = [];
    const iterationsMade: number[] = [];
    const stopReason: (StopReason | '')[] = [];
    const stepTimes: number[] = [];
    for (let step = 0; step < steps; step++) {
      let milliseconds = 0;
      for (let substep = 0; substep < substeps; substep++) milliseconds += timed(() => simulation.step());
      stepTimes.push(milliseconds);
      const { kinetic, springs, external } = simulation.energy();
      energy.push({ kinetic, spring: springs, gravity: external });
      objective.push(simulation.objective_at(simulation.p().slice()).objective);
      iterationsMade.push((simulation.last_half_step() - 1) / 2);
      stopReason.push(simulation.stop_reason());
    }
    return {
      p: simulation.p().slice(),
      velocity: simulation.velocity(),
      objective,
      energy,
      iterationsMade,
      stopReason,
      precompute,
      stepTimes,
    };
  } finally {
    simulation.delete();
  }
}
