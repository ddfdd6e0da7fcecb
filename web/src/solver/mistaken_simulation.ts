import type { MechanicalEnergy, Objective, Parameters, Status } from './module.ts';

/** The names of Mistake in wasm/core/mistake.h, same spelling, same order. */
export const mistakes = [
  'none',
  'd-once',
  'k-forgotten',
  'sign-in-A',
  'times-swapped',
  'rest-for-targets',
  'pins-after-solving',
  'factorised-again',
  'gradient-as-force',
  'stored-zeros',
  'one-iteration',
] as const;
export type Mistake = (typeof mistakes)[number];

/**
 * A simulation with one of the mistakes that students make: local/global on the plain path, sparse, whatever `method`, stopping rule, `path` and
 * `storage` say. With the mistake `none` it makes the same positions as `Simulation`, bit for bit.
 *
 * Called as `Simulation` is, of which it has the calls that a run needs. It never hands out a number that is not finite: the time step in which one
 * turns up fails with `diverged` and stays failed, `step_number`, `half_step` and the status's index tell where, and p() stays p^t. Coordinates
 * beyond a million times the largest of the rest positions (or of 1 m) count as diverged too; then `limit` is that, m, and otherwise 0.
 *
 * As there, a Float64Array is BORROWED, valid until the next call on the module.
 */
export interface MistakenSimulation {
  /** Replaces everything, at rest, cursor to (1, 0); on failure the previous scene stays. */
  set_scene(
    V: Float64Array,
    E: Int32Array,
    m: Float64Array,
    pinned: Int32Array,
    parameters: Parameters,
    mistake: Mistake,
  ): Status;
  /** On failure the previous parameters stay. What it changes holds from the next time step on, as do pins. */
  set_parameters(parameters: Parameters): Status;
  set_pins(pinned: Int32Array, targets: Float64Array): Status;
  reset(): Status;
  /** The known positions of time step `step`, each #V×3. The cursor is at predict: `half_step` has to be 0, as a mistaken time step has no trace. */
  set_state(step: number, p_curr: Float64Array, p_prev: Float64Array, half_step: 0): Status;

  /** Runs the current time step if the cursor is at predict, otherwise the next one. Cursor to accept, or to the half-step that failed. */
  step(): Status;

  step_number(): number;
  /** 0 predict, 2k global(k) where p became non-finite in it, 2K+1 accept. */
  half_step(): number;
  last_half_step(): number;
  vertex_count(): number;
  spring_count(): number;
  /** #V×3: p^{t+Δt} at accept, otherwise p^t. */
  p(): Float64Array;
  p_curr(): Float64Array;
  p_prev(): Float64Array;
  /** #E, m: rest lengths. */
  r(): Float64Array;
  /** #V: masses in use (scene × mass_scale). */
  m(): Float64Array;
  /** The right E(p) of the current time step, whatever the mistaken one lowers; not-a-numbers where p is not #V×3. */
  objective_at(p: Float64Array): Objective;
  /** As Simulation's: of the settled positions. */
  energy(): MechanicalEnergy;

  /** Of Q, since the simulation was made; those of calls that failed count too. */
  factorisation_count(): number;
  /** s: how long all of them took. */
  factorisation_time(): number;
  /** Entries that Q stores, those of them that are not zero, and entries that L stores. */
  stored_in_Q(): number;
  nonzeros_of_Q(): number;
  stored_in_L(): number;
  /** Releases the memory. One owner calls it once. */
  delete(): void;
}
