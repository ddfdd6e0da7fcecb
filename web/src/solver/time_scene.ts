import type { Parameters, SolverModule, Status } from './module.ts';
import type { Outcome, Pins, Problem } from './protocol.ts';

/** ms. */
export interface SceneTime {
  /** To factorise Q and whatever else is done once. */
  precomputation: number;
  /** One time step after it. */
  step: number;
}

/** What a scene costs by the clock, once: for what takes so long that nobody would repeat it. */
export function timeScene(
  solver: SolverModule,
  { V, E, m }: Problem,
  { pinned }: Pick<Pins, 'pinned'>,
  parameters: Parameters,
): Outcome<SceneTime> {
  const simulation = new solver.Simulation();
  try {
    const [opened, precomputation] = timed(() => simulation.set_scene(V, E, m, pinned, parameters));
    if (opened.code !== 'ok') return { ok: false, status: opened };
    const [stepped, step] = timed(() => simulation.step());
    if (stepped.code !== 'ok') return { ok: false, status: stepped };
    return { ok: true, value: { precomputation, step } };
  } finally {
    simulation.delete();
  }
}

function timed(call: () => Status): [Status, number] {
  const started = performance.now();
  const status = call();
  return [status, performance.now() - started];
}
