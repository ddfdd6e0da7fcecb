import type { Scene } from '../../web/src/scene/scene.ts';
import { type Method, methods, type SolverModule } from '../../web/src/solver/module.ts';
import { sceneParameters } from '../../web/src/solver/scene_parameters.ts';
import { milliseconds } from './milliseconds.ts';
import { median, sum } from './statistics.ts';
import { succeed } from './succeed.ts';

/** ms: what a time step of each method takes, and how many of linearly implicit Euler fit in a second. */
export interface IntegratorTimes {
  scene: string;
  steps: Record<string, number>;
  perSecond: number;
}

/** Time steps each, of which the first half warms up. */
const steps = 40;

/** The explicit methods take steps so much shorter, within their stable region on every scene. */
const explicitShare = 1 / 20;

/** A scene's first time steps from rest by all methods in turns, with its own settings: Newton to its end, the others 10 iterations. */
export function integratorTimes(solver: SolverModule, scene: Scene): IntegratorTimes {
  const running = methods.map((method) => {
    const simulation = new solver.Simulation();
    const { delta_t, ...rest } = sceneParameters(scene);
    const share = method === 'symplectic-euler' || method === 'forward-euler' ? explicitShare : 1;
    const parameters = { ...rest, delta_t: share * delta_t, iterations: method === 'newton' ? 100 : 10, method };
    succeed(simulation.set_scene(scene.V, scene.E, scene.m, scene.pinned, parameters));
    return { method, simulation, times: [] as number[] };
  });
  for (let step = 0; step < steps; step++) {
    for (const { simulation, times } of running) times.push(milliseconds(() => succeed(simulation.step())));
  }
  const time = ({ times }: { times: number[] }) => median(times.slice(steps / 2));
  for (const { simulation } of running) simulation.delete();
  const of = (wanted: Method) => running.find(({ method }) => method === wanted)?.times.slice(steps / 2) ?? [];
  const implicit = of('linearly-implicit');
  return {
    scene: scene.name,
    steps: Object.fromEntries(running.map((one) => [one.method, time(one)])),
    perSecond: (1e3 * implicit.length) / sum(implicit),
  };
}
