import type { Method, Parameters, Simulation, SolverModule, Status } from './module.ts';

/** A mass on one spring, whose other end is fixed at the origin. It starts at rest. */
export interface OneSpring {
  /** N/m. */
  k: number;
  /** kg. */
  m: number;
  /** m. */
  r: number;
  /** m/s². */
  gravity: number;
  /** m: where the mass starts, in the plane z = 0. */
  start: readonly [x: number, y: number];
}

export interface Way {
  method: Method;
  iterations: number;
}

/** More than Newton's method ever makes on one spring. */
export const toConvergence = 100;

/** rad/s: how fast the mass swings along the spring. */
export function angularFrequency({ k, m }: OneSpring): number {
  return Math.sqrt(k / m);
}

/** What the simulation says to its settings, as an error: they are ours, and none of them may be refused. */
export function demand({ code, field, value }: Status): void {
  if (code !== 'ok') throw new Error(`one spring: ${code} ${field} ${value}`);
}

/** Hands the spring, about to take its first time step, to `use`, and frees it. */
export function withOneSpring<T>(
  solver: SolverModule,
  { k, m, r, gravity, start }: OneSpring,
  { method, iterations }: Way,
  delta_t: number,
  use: (simulation: Simulation) => T,
): T {
  const parameters: Parameters = {
    k,
    delta_t,
    w: 1e10, // not used on the fast path
    mass_scale: 1,
    iterations,
    method,
    stop_gradient: 0,
    stop_decrease: 0,
    gravity,
    damping: 0,
    wind: false,
    path: 'fast',
    storage: 'sparse',
  };
  const simulation = new solver.Simulation();
  try {
    const rest = Float64Array.of(0, 0, 0, r, 0, 0);
    demand(simulation.set_scene(rest, Int32Array.of(0, 1), Float64Array.of(m, m), Int32Array.of(0), parameters));
    const p = Float64Array.of(0, 0, 0, ...start, 0);
    demand(simulation.set_state(1, p, p, 0));
    return use(simulation);
  } finally {
    simulation.delete();
  }
}
