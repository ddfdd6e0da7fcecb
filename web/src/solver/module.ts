/** Hand-written types of the WebAssembly module (Debian's Emscripten has no --emit-tsd); tests/wasm/module.test.ts holds them to the real one. */

import type { IkAnswer, IkMethod, IkTask } from './inverse_kinematics.ts';
import type { MistakenSimulation } from './mistaken_simulation.ts';

/** The names of StatusCode in wasm/core/status.h, same spelling, same order. */
export const statusCodes = [
  'ok',
  'no_scene',
  'no_vertices',
  'wrong_length',
  'not_finite',
  'index_out_of_range',
  'self_spring',
  'duplicate_spring',
  'duplicate_vertex',
  'not_positive',
  'negative',
  'too_stiff',
  'too_large',
  'factorisation_failed',
  'diverged',
  'unstable',
  'on_root',
] as const;
export type StatusCode = (typeof statusCodes)[number];

/** What a call that can fail returns. `field` names the argument (e.g. "E", "m", "delta_t"), `index` its row (or −1), `value` the offender. */
export interface Status {
  code: StatusCode;
  field: string;
  index: number;
  value: number;
  /** The most that `value` may be, of what is too stiff, unstable or too large (then in bytes); 0 elsewhere. */
  limit: number;
}

/** What a long call is at: finding the order of elimination, which cannot tell how far it is, and computing L. */
export type Stage = 'ordering' | 'factorising';

export type FactorisationReason =
  | 'scene'
  | 'k'
  | 'delta_t'
  | 'mass'
  | 'w'
  | 'damping'
  | 'pins'
  | 'pull'
  | 'path'
  | 'storage';

/** The methods that minimise E(p), iterate by iterate. */
export const minimisers = ['local-global', 'chebyshev', 'anderson', 'lbfgs', 'newton'] as const;
export type Minimiser = (typeof minimisers)[number];

/** The names of Method in wasm/core/method.h, same spelling, same order: those, and the ones that take a time step at once. */
export const methods = [...minimisers, 'linearly-implicit', 'symplectic-euler', 'forward-euler'] as const;
export type Method = (typeof methods)[number];

/**
 * The names of Ordering in wasm/core/ordering.h, same spelling, same order: the numbering of the scene; Eigen's approximate minimum degree, ties
 * broken by that numbering, which is what the plain path uses; and what the running solver uses, be it the fast path's own or the same.
 */
export const orderings = ['natural', 'minimum-degree', 'solver'] as const;
export type Ordering = (typeof orderings)[number];

/** Why a time step ended: after K iterations, by a stopping rule, or because no further step lowers E by more than rounding. */
export type StopReason = 'iterations' | 'gradient' | 'decrease' | 'rounding';

/** The core checks the numbers. Names are checked by these types alone: it takes an unknown one for local-global, plain or sparse. */
export interface Parameters {
  /** N/m. */
  k: number;
  /** s. */
  delta_t: number;
  /** N/m, pin penalty. */
  w: number;
  /** Dimensionless: multiplies every mass of the scene. */
  mass_scale: number;
  /** K: the most iterations of a time step. */
  iterations: number;
  /** How p^{t+Δt} follows from p^t; local-global is the paper's. Those that take the time step at once make one iteration whatever K says. */
  method: Method;
  /** N: a time step also ends where no component of ∂E/∂p of a vertex that is free to move is larger. 0: never. */
  stop_gradient: number;
  /** ε: and once an iteration lowers E by no more than ε max(1 J, |E|). 0: never. */
  stop_decrease: number;
  /** m/s²: g = (0, −gravity, 0). */
  gravity: number;
  /** c, N·s/m: of a dashpot beside every spring, 0 for none. The methods that minimise take its direction at p^t and its velocity at t+Δt. */
  damping: number;
  /** Whether the course's wind blows. */
  wind: boolean;
  /** `plain`: the readable functions, pins by penalty. `fast`: the same iteration arranged for speed, pins exactly where they are held, no w. */
  path: 'fast' | 'plain';
  /** Of the plain path. */
  storage: 'sparse' | 'dense';
}

/** Of a time step that comes about iterate by iterate. */
export type MinimisingParameters = Parameters & { method: Minimiser };

/** A sparse matrix as triplets, for tests and the matrix views. Each (row, column) occurs once. */
export interface Triplets {
  rows: number;
  columns: number;
  i: Int32Array;
  j: Int32Array;
  value: Float64Array;
}

/** E(p) and its terms, J. */
export interface Objective {
  objective: number;
  potential: number;
  inertia: number;
  external: number;
  pin: number;
  damping: number;
  pull: number;
}

/** Of masses on springs, J. A motion without loss keeps the sum. */
export interface MechanicalEnergy {
  /** ½ Σ m_i ‖v_i‖², v the change of the positions in a time step over Δt. */
  kinetic: number;
  springs: number;
  /** −Σ p_iᵀ f_i^ext: of gravity, and of wind as if it blew on as now. */
  external: number;
}

/** The parts of row i of Q p = b, b = k Aᵀ d + y, for the d and p of the cursor. Each #3. */
export interface VertexProbe {
  y: number[];
  kAtd: number[];
  b: number[];
  Qp: number[];
  /** The springs at vertex i, ascending; #springs×3: what each adds to kAtd, k d_e where i is its first vertex, −k d_e where it is its second. */
  springs: Int32Array;
  shares: Float64Array;
}

/**
 * One simulation: scene, parameters, pins, the known positions p^t and p^{t−Δt}, and a cursor inside the time step that computes p^{t+Δt}.
 *
 * The cursor (step, half_step) is a place in the trace of that time step, with K iterations:
 *   half_step 0 predict · 2k−1 local(k) · 2k global(k), k = 1…K · 2K+1 accept.
 * Everything the trace shows is a pure function of (p^t, p^{t−Δt}, parameters, pins, pull, half_step): stepping back recomputes, bit for bit.
 *
 * Every Float64Array returned here is a BORROWED view of wasm memory, valid until the next call on the module: copy what is kept.
 */
export interface Simulation {
  /** Has every call that factorises tell, from inside, which fraction of a stage is done. */
  set_progress(report: (stage: Stage, fraction: number) => void): void;

  /** Replaces everything; on failure the previous scene stays, untouched. V #V×3, E #E×2, m #V, pinned #pinned, row-major. Cursor to (1, 0). */
  set_scene(V: Float64Array, E: Int32Array, m: Float64Array, pinned: Int32Array, parameters: Parameters): Status;
  /** Refactorises when k, delta_t, w, mass_scale or damping changed; on failure the previous parameters stay. */
  set_parameters(parameters: Parameters): Status;
  /** The set of pinned vertices and where each is held (#pinned×3). Refactorises only when the SET changed. */
  set_pins(pinned: Int32Array, targets: Float64Array): Status;
  /**
   * Springs of rest length 0 and stiffness k, N/m, from these vertices each to a point of its own (#vertices×3), until reset; none for no vertices.
   * Refactorises only when the SET of vertices or k changed.
   */
  set_pull(vertices: Int32Array, targets: Float64Array, k: number): Status;
  /** Rest positions, at rest, nothing pulled, cursor to (1, 0). Pins keep their set and return to their rest positions. */
  reset(): Status;
  /** Restores a checkpoint: the known positions of time step `step`, each #V×3, and the half step the cursor stands at. */
  set_state(step: number, p_curr: Float64Array, p_prev: Float64Array, half_step: number): Status;

  /** Full speed, records nothing: completes the current time step if the cursor is inside it, otherwise runs the next one whole. Cursor to accept. */
  step(): Status;
  /** Moves the cursor inside the current time step (0 … 2K+1), tracing as far as needed; beyond an earlier end, to that. */
  seek(half_step: number): Status;
  /** From accept: p^{t−Δt} ← p^t, p^t ← p, cursor to (step+1, 0). From elsewhere: completes the step first. */
  next_step(): Status;
  /** Back to accept of the previous time step (retraced). False when there is none remembered. */
  previous_step(): boolean;
  /** Back to accept of an earlier time step, retraced. False, and nothing changed, where that step is not earlier or not remembered. */
  back_to(step: number): boolean;
  /** How many earlier time steps can still be returned to. */
  remembered_steps(): number;

  step_number(): number;
  half_step(): number;
  /** 2K+1; once the current time step is known to end after k < K iterations, 2k+1. */
  last_half_step(): number;
  /** Of the current time step; empty as long as its end is not known. */
  stop_reason(): StopReason | '';

  vertex_count(): number;
  spring_count(): number;
  /** #V×3: the iterate at the cursor. */
  p(): Float64Array;
  /** #V×3: the iterate before it (p^t at predict and in iteration 1's local step). The projection d was computed from this one at global. */
  p_before(): Float64Array;
  /** #V×3: p^t and p^{t−Δt}. */
  p_curr(): Float64Array;
  p_prev(): Float64Array;
  /** #V×3: where inertia and external forces alone would carry each vertex, 2p^t − p^{t−Δt} + Δt² M⁻¹ f^ext. */
  inertial_prediction(): Float64Array;
  /** #V×3: where the forces at p^t would carry each vertex, instead of those at p^{t+Δt}: an explicit step. */
  explicit_step(): Float64Array;
  /** #E×3: the projection at the cursor (at predict: the unprojected p_i − p_j). */
  d(): Float64Array;
  /** #E. */
  r(): Float64Array;
  /** #V: masses in use (scene × mass_scale). */
  m(): Float64Array;
  /** #pinned×3. */
  targets(): Float64Array;
  /**
   * One row of `traceColumns` per half-step traced so far in this time step (0 … furthest), row-major.
   * Columns: half_step, objective E(p), surrogate Ẽ(p,d), potential, inertia, external, pin, gradient ‖∂E/∂p‖∞ of the vertices that are free to
   * move, residual ‖Qp−b‖∞ (NaN but at global of local-global: nothing else solves Qp = b) and change max_i‖p_i − p_before_i‖ (0 unless global).
   */
  trace(): Float64Array;
  /**
   * The current time step by any method, from p^t with the pins where they are held; cursor and trace stay. A row of `compareColumns` for every
   * iteration from 0 until `iterations` are made or E falls no further, row-major: E(p^k) − E(p^0), ‖∂E/∂p‖∞ of the vertices that are free, and
   * what `stop_decrease` is compared with, (E(p^{k−1}) − E(p^k)) / max(1 J, |E(p^k)|), NaN for k = 0.
   */
  compare(method: Method, iterations: number): { status: Status; rows: Float64Array };
  /** So many local steps (on the fast path: ∂E/∂p) or global steps (Q⁻¹) from p^t, whose results nobody uses: to be timed from outside. */
  rehearse_local_step(times: number): void;
  rehearse_global_step(times: number): void;
  probe_vertex(i: number): VertexProbe;
  /** Of the settled positions: at accept p, elsewhere p^t. */
  energy(): MechanicalEnergy;
  /** #V×3, m/s: likewise. Also where the method is forward Euler, whose last change of the positions is an older velocity. */
  velocity(): Float64Array;
  /** ω of the fastest oscillation of springs and pulls around the settled positions, rad/s, to half a percent. Takes some ms. */
  largest_frequency(): number;
  /** How large Δt ω may be before the oscillation grows: 2 for symplectic Euler, 0 for forward Euler without damping; infinite for the others. */
  stability_limit(): number;
  /** Max_i Σ_j k_ij Δt²/m_i, dimensionless. */
  stiffness_number(): number;
  /** Without those of calls that failed. */
  factorisation_count(): number;
  /** Why the last of them happened. */
  factorisation_reason(): FactorisationReason;

  /** For tests and matrix views: the matrices of mathematics.md as triplets (copies). */
  A(): Triplets;
  M(): Triplets;
  C(): Triplets;
  Q(): Triplets;
  /** AᵀA and the three terms of Q: kAᵀA, M/Δt², wCᵀC; of dashpots and pulls Q has two more, which are not among them. */
  system_matrix_terms(): { AtA: Triplets; springs: Triplets; masses: Triplets; pins: Triplets };
  /**
   * The matrix of linearly implicit Euler at the settled positions (at accept p, elsewhere p^t), and what it is made of. Coordinate c of vertex i
   * is row 3i + c. K: ∂f/∂q, N/m. D: ∂f/∂q̇, N·s/m, no entries without damping. P: selects the coordinates of the vertices that are not
   * pinned, in their order. system: M − Δt D − Δt² K, kg. constrained: P (M − Δt D − Δt² K) Pᵀ, kg. Entries that the pattern has are listed
   * also where they happen to be 0.
   */
  linearly_implicit_terms(): { K: Triplets; D: Triplets; P: Triplets; system: Triplets; constrained: Triplets };
  /** #V×3, m: the settled positions. */
  settled(): Float64Array;
  /**
   * 3×3, N/m, a copy: H_e = k [nnᵀ + (1 − l⁰/l)(I − nnᵀ)] of spring e at the settled positions. K is the sum of −H_e at (i, i) and (j, j) and of
   * +H_e at (i, j) and (j, i). Not-a-numbers where there is no spring e.
   */
  spring_stiffness(e: number): Float64Array;
  /** 3×3, N·s/m, a copy: C nnᵀ of its dashpot, of which D is made likewise. */
  spring_resistance(e: number): Float64Array;
  /** #unknowns: in that order, the vertices whose rows of Q p = b are factorised; on the fast path pinned ones are not among them. */
  order(ordering: Ordering): Int32Array;
  /** Of Q with these rows and columns, in this order. Whoever asked deletes it. */
  elimination(ordering: Ordering): Elimination;
  /** The system of these rows and columns, however it is ordered, loaded by gravity. Whoever asked deletes it. */
  solving_example(): SolvingExample;
  y(): Float64Array;
  /** E(p) of the current time step at any p (#V×3), with its terms. */
  objective_at(p: Float64Array): Objective;
  /** #V×3: ∂E/∂p at any p. */
  gradient_at(p: Float64Array): Float64Array;
  /** Releases the memory. One owner calls it once. */
  delete(): void;
}

export const traceColumns = [
  'half_step',
  'objective',
  'surrogate',
  'potential',
  'inertia',
  'external',
  'pin',
  'gradient',
  'residual',
  'change',
] as const;

/** J, N, dimensionless. */
export const compareColumns = ['iteration', 'change', 'gradient', 'decrease'] as const;

/** P Q Pᵀ = L Lᵀ in a given order of elimination. Rows and columns are numbered in that order. */
export interface Elimination {
  /** #columns: the vertex of each. */
  order(): Int32Array;
  /** #columns: the row of the first non-zero below the diagonal of each column of L, or −1; and how many there are. */
  parent(): Int32Array;
  height(): Int32Array;
  /** Of L, the diagonal included; of the lower triangle of Q, likewise; and the difference. */
  nonzeros(): number;
  nonzeros_of_Q(): number;
  fill(): number;
  /** Σ c², c = 1 + height: all arithmetic operations. */
  flops(): number;
  /** Above so many, L is not computed: factorise() does nothing and after() is too_large. */
  most_flops(): number;
  /** All of L by Eigen's algorithm, to be timed from outside. False also where Q is not positive definite. */
  factorise(): boolean;
  /**
   * The lower triangle once so many columns are eliminated, column by column, rows ascending. born, #entries: 0 for those of Q, else after how many
   * columns they came into being. No entries where the status is not ok.
   */
  after(columns: number): Triplets & { born: Int32Array; status: Status };
  delete(): void;
}

/**
 * Q p = b, by its constructor for a square net of side × side vertices, and the ways to solve it, each a call to be timed from outside. A
 * substitution comes after its factorisation. Of more than 2,025 unknowns the dense calls do nothing and return false: such matrices are too large
 * to be worth waiting for.
 */
export interface SolvingExample {
  vertex_count(): number;
  dense_inverse(): boolean;
  dense_factorise(): boolean;
  dense_substitute(): boolean;
  sparse_factorise(): void;
  sparse_substitute(): void;
  /** Of Q, and once it is factorised of L: n² numbers for either if dense, else the non-zeros with their rows. */
  dense_bytes(): number;
  sparse_matrix_bytes(): number;
  sparse_factor_bytes(): number;
  /** max |Qp − b| of the last substitution, N. */
  residual(): number;
  delete(): void;
}

export interface SolverModule {
  Simulation: new () => Simulation;
  MistakenSimulation: new () => MistakenSimulation;
  SolvingExample: new (side: number) => SolvingExample;
  Elimination: { prototype: Elimination };
  /** The answer is meaningless where the status is not ok. */
  inverse_kinematics(task: IkTask): { status: Status; answer: IkAnswer };
  /** Of every outcome and method of inverse kinematics. */
  ik_outcomes(): string[];
  ik_methods(): IkMethod[];
  /** The spelling of every StatusCode, in order: tests hold `statusCodes` above to it. */
  status_codes(): string[];
  /** Of every Method, Mistake and Ordering, likewise. */
  methods(): string[];
  mistakes(): string[];
  orderings(): string[];
}

/** The factory that Emscripten generates. `wasmBinary` is handed in so Node, Vitest and browsers load the same file the same way. */
export type CreateSolver = (options: { wasmBinary: ArrayBuffer | Uint8Array }) => Promise<SolverModule>;
