import type { Mistake, MistakenSimulation } from './mistaken_simulation.ts';
import type { MechanicalEnergy, Parameters, Simulation, SolverModule, Status } from './module.ts';
import type { Checkpoint, Outcome, Pins, Problem } from './protocol.ts';

/** One of several simulations of the same problem. */
export interface Variant {
  parameters: Parameters;
  mistake: Mistake;
}

/** What one of them has come to. */
export interface VariantState {
  /** #V×3, m. */
  p: Float64Array;
  /** J, after each time step of the request that did not fail. */
  energies: MechanicalEnergy[];
  /** Wall-clock ms of a time step of the request, on average. */
  milliseconds: number;
  /** Of Q, since the beginning. */
  factorisations: number;
  /** What only a variant with a mistake tells. */
  cost: {
    /** Wall-clock ms of all its factorisations. */
    factorising: number;
    /** Entries that Q stores, and those of them that are not zero. */
    storedInQ: number;
    nonzerosOfQ: number;
  } | null;
  /** Why it stands still: the time step that failed, and the half-step where that is known. */
  failure: { status: Status; step: number; half_step: number | null } | null;
}

export interface OpenedSideBySide {
  states: VariantState[];
  /** #E, m: rest lengths. */
  r: Float64Array;
}

/** The worker's side, as comlink exposes it. */
export interface SideBySideService {
  /** Compiles the module. Call once, before anything else. */
  start(wasmBinary: ArrayBuffer): Promise<void>;
  /** One variant at least, all from the same positions: at rest, or those that a checkpoint's time step starts from. Not ok: the first refusal, and those open before stay. */
  open(
    problem: Problem,
    variants: readonly Variant[],
    pins: Pins,
    from: Checkpoint | null,
  ): Promise<Outcome<OpenedSideBySide>>;
  /** All make so many time steps with the same pins. One that fails stays as it was before and does not hold the others back. */
  run(pins: Pins, steps: number): Promise<VariantState[]>;
}

/** What both kinds of simulation can do. */
type Runner = Pick<
  Simulation & MistakenSimulation,
  | 'set_pins'
  | 'set_state'
  | 'step'
  | 'step_number'
  | 'half_step'
  | 'last_half_step'
  | 'p'
  | 'r'
  | 'energy'
  | 'factorisation_count'
  | 'delete'
>;

interface Running {
  simulation: Runner;
  cost: () => VariantState['cost'];
  failure: VariantState['failure'];
}

/** Owns the simulations and makes them take turns. Runs in a worker; knows neither worker nor page. */
export class SideBySideSession {
  private readonly module: SolverModule;
  private runners: Running[] = [];

  constructor(module: SolverModule) {
    this.module = module;
  }

  open(problem: Problem, variants: readonly Variant[], pins: Pins, from: Checkpoint | null): Outcome<OpenedSideBySide> {
    const next: typeof this.runners = [];
    for (const variant of variants) {
      const [runner, opened] = this.runnerOf(problem, variant, pins);
      const { simulation } = runner;
      next.push(runner);
      let status = opened;
      if (status.code === 'ok') status = simulation.set_pins(pins.pinned, pins.targets);
      if (status.code === 'ok' && from) status = simulation.set_state(from.step, from.p_curr, from.p_prev, 0);
      if (status.code === 'ok') continue;
      release(next);
      return { ok: false, status };
    }
    release(this.runners);
    this.runners = next;
    const r = next[0].simulation.r().slice();
    return { ok: true, value: { states: next.map((runner) => stateOf(runner, [], 0)), r } };
  }

  run(pins: Pins, steps: number): VariantState[] {
    return this.runners.map((runner) => {
      const { simulation } = runner;
      const energies: MechanicalEnergy[] = [];
      const started = performance.now();
      const moved = simulation.set_pins(pins.pinned, pins.targets);
      if (moved.code !== 'ok') runner.failure ??= failureOf(simulation, moved);
      while (!runner.failure && energies.length < steps) {
        const status = simulation.step();
        if (status.code === 'ok') energies.push(simulation.energy());
        else runner.failure = failureOf(simulation, status);
      }
      return stateOf(runner, energies, (performance.now() - started) / Math.max(1, steps));
    });
  }

  private runnerOf({ V, E, m }: Problem, { parameters, mistake }: Variant, { pinned }: Pins): [Running, Status] {
    if (mistake === 'none') {
      const simulation = new this.module.Simulation();
      return [{ simulation, cost: () => null, failure: null }, simulation.set_scene(V, E, m, pinned, parameters)];
    }
    const simulation = new this.module.MistakenSimulation();
    const cost = () => ({
      factorising: 1e3 * simulation.factorisation_time(),
      storedInQ: simulation.stored_in_Q(),
      nonzerosOfQ: simulation.nonzeros_of_Q(),
    });
    return [{ simulation, cost, failure: null }, simulation.set_scene(V, E, m, pinned, parameters, mistake)];
  }
}

function release(runners: readonly { simulation: Runner }[]): void {
  for (const { simulation } of runners) simulation.delete();
}

function stateOf(
  { simulation, cost, failure }: Running,
  energies: MechanicalEnergy[],
  milliseconds: number,
): VariantState {
  return {
    p: simulation.p().slice(),
    energies,
    milliseconds,
    factorisations: simulation.factorisation_count(),
    cost: cost(),
    failure,
  };
}

/** A simulation that cannot tell in which half-step it failed stands at the end of the time step before. */
function failureOf(simulation: Runner, status: Status): VariantState['failure'] {
  const half_step = simulation.half_step();
  return half_step < simulation.last_half_step()
    ? { status, step: simulation.step_number(), half_step }
    : { status, step: simulation.step_number() + 1, half_step: null };
}
