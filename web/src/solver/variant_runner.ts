import { sameJson } from '../lib/same_json.ts';
import type { Mistake, MistakenSimulation } from './mistaken_simulation.ts';
import type { MechanicalEnergy, Parameters, Simulation, SolverModule, Status } from './module.ts';
import type { Checkpoint, Pins, Problem, Pull } from './protocol.ts';

/** One of several simulations of the same problem. */
export interface Variant {
  /** Δt is of the whole time step. */
  parameters: Parameters;
  /** N: a time step is made as N steps of Δt/N. */
  substeps: number;
  mistake: Mistake;
}

/** Where everything is and how fast it moves: #V×3 each, m and m/s. */
export interface Motion {
  p: Float64Array;
  v: Float64Array;
}

/** What only a variant with a mistake tells. */
export interface MistakeCost {
  /** Wall-clock ms of all its factorisations. */
  factorising: number;
  /** Entries that Q stores, and those of them that are not zero. */
  storedInQ: number;
  nonzerosOfQ: number;
}

/** Why a variant stands still: the time step that failed, and the half-step where that is known. */
export interface Failure {
  status: Status;
  step: number;
  half_step: number | null;
}

const ok: Status = { code: 'ok', field: '', index: -1, value: 0, limit: 0 };

const noPull: Pull = { vertices: new Int32Array(), targets: new Float64Array(), stiffness: 1 };

/** A variant at work. Whoever makes it deletes it. */
export class VariantRunner {
  failure: Failure | null = null;
  variant: Variant;
  private readonly simulation: Simulation | MistakenSimulation;
  /** The same: one of them, by whether it makes a mistake. */
  private readonly right: Simulation | null;
  private readonly mistaken: MistakenSimulation | null;
  /** Σ m_i y_i at rest, kg·m. */
  private massTimesHeight = 0;

  constructor(module: SolverModule, variant: Variant) {
    this.variant = variant;
    this.right = variant.mistake === 'none' ? new module.Simulation() : null;
    this.mistaken = this.right ? null : new module.MistakenSimulation();
    this.simulation = (this.right ?? this.mistaken) as Simulation | MistakenSimulation;
  }

  open({ V, E, m }: Problem, { pinned, targets }: Pins): Status {
    const parameters = ofSubstep(this.variant);
    this.massTimesHeight = m.reduce((sum, mass, i) => sum + mass * V[3 * i + 1], 0);
    const opened =
      this.right?.set_scene(V, E, m, pinned, parameters) ??
      (this.mistaken as MistakenSimulation).set_scene(V, E, m, pinned, parameters, this.variant.mistake);
    return opened.code === 'ok' ? this.simulation.set_pins(pinned, targets) : opened;
  }

  /** Whether the same simulation can become that variant. */
  fits({ mistake }: Variant): boolean {
    return mistake === this.variant.mistake;
  }

  /** Other settings; the motion goes on. Refused: all is as before. `step`: the number of the time step that comes next. */
  change(variant: Variant, step: number): Status {
    if (sameJson(variant, this.variant)) return ok;
    const motion = this.motion();
    const before = this.variant;
    const status = this.set(variant, motion, step);
    if (status.code === 'ok')
      this.failure = null; // what failed may be able to go on now
    else this.set(before, motion, step);
    return status;
  }

  private set(variant: Variant, motion: Motion, step: number): Status {
    const status = this.simulation.set_parameters(ofSubstep(variant));
    if (status.code !== 'ok') return status;
    this.variant = variant;
    return this.move(motion, step);
  }

  /** As it was before a step that failed. */
  motion(): Motion {
    const { simulation } = this;
    const p = simulation.p().slice();
    if (this.right) return { p, v: this.right.velocity().slice() };
    const h = ofSubstep(this.variant).delta_t;
    const settled = simulation.half_step() === simulation.last_half_step();
    const before = settled ? simulation.p_curr().slice() : simulation.p_prev().slice();
    return { p, v: before.map((q, c) => (p[c] - q) / h) };
  }

  /** Puts it into a motion, with that time step to come next. */
  move({ p, v }: Motion, step: number): Status {
    const h = ofSubstep(this.variant).delta_t;
    const before = p.map((x, c) => x - h * v[c]);
    return this.simulation.set_state(firstSubstep(step, this.variant), p, before, 0);
  }

  /** Goes on from another's motion, whatever became of its own. */
  join(motion: Motion, step: number): void {
    const status = this.move(motion, step);
    this.failure = status.code === 'ok' ? null : this.failureOf(status, step);
  }

  /** Puts it where a checkpoint's time step begins. */
  moveTo({ step, p_curr, p_prev }: Checkpoint): Status {
    const share = 1 - 1 / this.variant.substeps;
    const before = p_prev.map((x, c) => x + share * (p_curr[c] - x)); // without substeps p_prev itself, bit for bit
    return this.simulation.set_state(firstSubstep(step, this.variant), p_curr, before, 0);
  }

  /** So many time steps from the one of this number on; fewer where one fails. Returns the energies after each, J, gravity's from the rest positions. */
  run(pins: Pins, pull: Pull | null, step: number, steps: number): MechanicalEnergy[] {
    const energies: MechanicalEnergy[] = [];
    const status = this.hold(pins, pull);
    if (status.code !== 'ok') this.failure ??= this.failureOf(status, step);
    while (!this.failure && energies.length < steps) {
      const made = this.step();
      if (made.code === 'ok') energies.push(this.energy());
      else this.failure = this.failureOf(made, step + energies.length);
    }
    return energies;
  }

  private energy(): MechanicalEnergy {
    const { kinetic, springs, external } = this.simulation.energy();
    const { gravity, mass_scale } = this.variant.parameters;
    return { kinetic, springs, external: external - gravity * mass_scale * this.massTimesHeight };
  }

  private hold({ pinned, targets }: Pins, pull: Pull | null): Status {
    const status = this.simulation.set_pins(pinned, targets);
    if (status.code !== 'ok' || !this.right) return status; // who makes mistakes on purpose is not pulled
    const { vertices, targets: ends, stiffness } = pull ?? noPull;
    return this.right.set_pull(vertices, ends, stiffness);
  }

  private step(): Status {
    let status = ok;
    for (let made = 0; made < this.variant.substeps && status.code === 'ok'; made++) status = this.simulation.step();
    return status;
  }

  /** A simulation that cannot tell in which half-step it failed stands at the end of the step before. */
  private failureOf(status: Status, step: number): Failure {
    const half_step = this.simulation.half_step();
    return { status, step, half_step: half_step < this.simulation.last_half_step() ? half_step : null };
  }

  /** #V×3, m: a copy. */
  p(): Float64Array {
    return this.simulation.p().slice();
  }

  /** J: E(p) of the time step just made, at any p. */
  objective(p: Float64Array): number {
    return this.simulation.objective_at(p).objective;
  }

  /** ω, rad/s, of the fastest oscillation around where it is; not a number where it makes a mistake. */
  frequency(): number {
    return this.right?.largest_frequency() ?? Number.NaN;
  }

  /** #E, m: a copy of the rest lengths. */
  r(): Float64Array {
    return this.simulation.r().slice();
  }

  /** Of Q, since the beginning. */
  factorisations(): number {
    return this.simulation.factorisation_count();
  }

  cost(): MistakeCost | null {
    return (
      this.mistaken && {
        factorising: 1e3 * this.mistaken.factorisation_time(),
        storedInQ: this.mistaken.stored_in_Q(),
        nonzerosOfQ: this.mistaken.nonzeros_of_Q(),
      }
    );
  }

  delete(): void {
    this.simulation.delete();
  }
}

function ofSubstep({ parameters, substeps }: Variant): Parameters {
  return { ...parameters, delta_t: parameters.delta_t / substeps };
}

/** The number that a variant gives to the first of the substeps of a time step. */
function firstSubstep(step: number, { substeps }: Variant): number {
  return (step - 1) * substeps + 1;
}
