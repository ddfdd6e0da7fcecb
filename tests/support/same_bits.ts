import { createHash } from 'node:crypto';
import { type Method, methods, type Parameters, type SolverModule } from '../../web/src/solver/module.ts';
import { openScene } from './open_scene.ts';
import { net, type SmallScene, usualParameters } from './small_scenes.ts';

/** What ends in the same bits natively, in Node and in the page's worker. */
export interface Run {
  name: string;
  scene: SmallScene;
  parameters: Parameters;
  steps: number;
}

/** Ten seconds of motion: a difference in one bit has long spread over all of them. */
const steps = 300;

const net36 = { scene: net(6), parameters: usualParameters };
const scene = await openScene('tower');
const tower = { scene, parameters: { ...usualParameters, k: scene.k } };

function run({ scene, parameters }: typeof net36, how: Partial<Parameters>): Run {
  const name = `${scene.m.length} vertices, ${Object.values(how).join(', ')}`;
  return { name, scene, parameters: { ...parameters, ...how }, steps };
}

/** The explicit methods with steps so short that 300 of them go well. */
function choice(method: Method, path: Parameters['path']): Partial<Parameters> {
  const explicit = method === 'symplectic-euler' || method === 'forward-euler';
  return { method, path, ...(explicit && { delta_t: 1e-4 }) };
}

/** Without wind, whose sines and cosines are the C library's. */
export const runs: Run[] = [
  ...methods.flatMap((method) => [run(net36, choice(method, 'plain')), run(net36, choice(method, 'fast'))]),
  run(net36, { path: 'plain', storage: 'dense' }),
  run(tower, { path: 'plain' }),
  // Newton is left out, who factorises in every iteration: a minute natively, where sanitizers watch.
  ...methods.filter((method) => method !== 'newton').map((method) => run(tower, choice(method, 'fast'))),
  // Large enough for products in blocks.
  { ...run(tower, { path: 'plain', storage: 'dense' }), steps: 3 },
];

export function runInNode(solver: SolverModule, { scene, parameters, steps }: Run): Float64Array {
  const simulation = new solver.Simulation();
  try {
    const statuses = [simulation.set_scene(scene.V, scene.E, scene.m, scene.pinned, parameters)];
    for (let step = 0; step < steps; step++) statuses.push(simulation.step());
    const failed = statuses.find(({ code }) => code !== 'ok');
    if (failed) throw new Error(`${failed.code}: ${failed.field}`);
    return simulation.p().slice();
  } finally {
    simulation.delete();
  }
}

/** SHA-256, hexadecimal, of positions (#V×3, m) as little-endian doubles. */
export function hashOf(positions: Float64Array): string {
  return createHash('sha256').update(new Uint8Array(positions.buffer)).digest('hex');
}
