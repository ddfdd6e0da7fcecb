import { sameJson } from '../lib/same_json.ts';
import { ExactStep, type StepError } from './exact_step.ts';
import type { MechanicalEnergy, SolverModule, Status } from './module.ts';
import type { Checkpoint, Outcome, Pins, Problem, Pull } from './protocol.ts';
import { type Failure, type MistakeCost, type Motion, type Variant, VariantRunner } from './variant_runner.ts';

export type { Variant };

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
  cost: MistakeCost | null;
  /** Why it stands still. */
  failure: Failure | null;
}

export interface OpenedSideBySide {
  states: VariantState[];
  /** ω, rad/s, of the fastest oscillation around where the first one is. */
  frequency: number;
  /** #E, m: rest lengths. */
  r: Float64Array;
}

export interface ChangedSideBySide {
  states: VariantState[];
  frequency: number;
  /** For each, which of those before it goes on from; null where it is new. */
  from: (number | null)[];
}

/** One time step by every variant, from the motion of one of them. */
export interface Instant {
  states: VariantState[];
  /** Of each, how far it is from p*, the minimiser of the leader's E(p): max_i ‖p_i − p*_i‖, m, and E(p) − E(p*), J. Null where the step failed. */
  errors: (StepError | null)[];
  /** Wall-clock ms that finding p* took. */
  milliseconds: number;
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
  /** Other methods or settings, and fewer or more variants: those that go on keep their motion, and who is new takes that of the first that moves. Not ok: nothing has changed. */
  change(variants: readonly Variant[]): Promise<Outcome<ChangedSideBySide>>;
  /** All make so many time steps with the same pins and pull. One that fails stays as it was before and does not hold the others back. */
  run(pins: Pins, pull: Pull | null, steps: number): Promise<VariantState[]>;
  /** All take the motion of one of them and make a time step from it: this one step by every method. */
  sameInstant(leader: number, pins: Pins, pull: Pull | null): Promise<Outcome<Instant>>;
}

/** Owns the simulations and makes them take turns. Runs in a worker; knows neither worker nor page. */
export class SideBySideSession {
  private readonly module: SolverModule;
  private problem: Problem | null = null;
  private pins: Pins = { pinned: new Int32Array(), targets: new Float64Array() };
  private runners: VariantRunner[] = [];
  /** The number of the time step that comes next. */
  private next = 1;

  constructor(module: SolverModule) {
    this.module = module;
  }

  open(problem: Problem, variants: readonly Variant[], pins: Pins, from: Checkpoint | null): Outcome<OpenedSideBySide> {
    const opened: VariantRunner[] = [];
    for (const variant of variants) {
      const runner = new VariantRunner(this.module, variant);
      opened.push(runner);
      let status = runner.open(problem, pins);
      if (status.code === 'ok' && from) status = runner.moveTo(from);
      if (status.code !== 'ok') return refused(status, opened);
    }
    release(this.runners);
    Object.assign(this, { problem, pins, runners: opened, next: from?.step ?? 1 });
    const states = opened.map((runner) => stateOf(runner, [], 0));
    return { ok: true, value: { states, frequency: opened[0].frequency(), r: opened[0].r() } };
  }

  change(variants: readonly Variant[]): Outcome<ChangedSideBySide> {
    const from = this.continued(variants);
    const motion = (this.runners.find(({ failure }) => !failure) ?? this.runners[0]).motion();
    const made: VariantRunner[] = [];
    const next = variants.map((variant, at) => {
      const continued = from[at];
      if (continued !== null) return this.runners[continued];
      const runner = new VariantRunner(this.module, variant);
      made.push(runner);
      return runner;
    });
    const before = this.runners.map(({ variant, failure }) => ({ variant, failure }));
    for (const [at, runner] of next.entries()) {
      const status = made.includes(runner) ? this.begin(runner, motion) : runner.change(variants[at], this.next);
      if (status.code === 'ok') continue;
      this.runners.forEach((one, index) => {
        one.change(before[index].variant, this.next);
        one.failure = before[index].failure;
      });
      return refused(status, made);
    }
    release(this.runners.filter((runner) => !next.includes(runner)));
    this.runners = next;
    const states = next.map((runner) => stateOf(runner, [], 0));
    return { ok: true, value: { states, frequency: next[0].frequency(), from } };
  }

  run(pins: Pins, pull: Pull | null, steps: number): VariantState[] {
    const states = this.runners.map((runner) => this.runOne(runner, pins, pull, steps));
    this.pins = pins;
    this.next += steps;
    return states;
  }

  sameInstant(leader: number, pins: Pins, pull: Pull | null): Outcome<Instant> {
    const { variant } = this.runners[leader];
    const exact = new ExactStep(this.module, variant);
    try {
      const motion = this.runners[leader].motion();
      const status = exact.solve(this.problem as Problem, pins, pull, motion, this.next); // open: there is a leader
      if (status.code !== 'ok') return { ok: false, status };
      for (const runner of this.runners) runner.join(motion, this.next);
      const states = this.run(pins, pull, 1);
      const errors = states.map(({ p, failure }) => (failure ? null : exact.errorOf(p)));
      return { ok: true, value: { states, errors, milliseconds: exact.milliseconds } };
    } finally {
      exact.delete();
    }
  }

  private runOne(runner: VariantRunner, pins: Pins, pull: Pull | null, steps: number): VariantState {
    const started = performance.now();
    const energies = runner.run(pins, pull, this.next, steps);
    return stateOf(runner, energies, (performance.now() - started) / Math.max(1, steps));
  }

  /** Which of those that run each of the wanted goes on from: its equal, or else the first that nobody is equal to. */
  private continued(variants: readonly Variant[]): (number | null)[] {
    const left = new Set(this.runners.keys());
    const take = (before: number | undefined) => {
      if (before === undefined) return null;
      left.delete(before);
      return before;
    };
    const find = (fits: (before: number) => boolean) => take([...left].find(fits));
    const equals = variants.map((variant) => find((before) => sameJson(this.runners[before].variant, variant)));
    return variants.map((variant, at) => equals[at] ?? find((before) => this.runners[before].fits(variant)));
  }

  private begin(runner: VariantRunner, motion: Motion): Status {
    const status = runner.open(this.problem as Problem, this.pins); // open: there is a motion
    return status.code === 'ok' ? runner.move(motion, this.next) : status;
  }
}

function refused(status: Status, made: readonly VariantRunner[]): { ok: false; status: Status } {
  release(made);
  return { ok: false, status };
}

function release(runners: readonly VariantRunner[]): void {
  for (const runner of runners) runner.delete();
}

function stateOf(runner: VariantRunner, energies: MechanicalEnergy[], milliseconds: number): VariantState {
  return {
    p: runner.p(),
    energies,
    milliseconds,
    factorisations: runner.factorisations(),
    cost: runner.cost(),
    failure: runner.failure,
  };
}
