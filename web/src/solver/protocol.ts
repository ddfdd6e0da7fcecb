import type { Frame, VertexEquation } from './frame.ts';
import type {
  Elimination,
  EliminationStep,
  EliminationStepRequest,
  LinearlyImplicitMatrices,
  Matrices,
  StorageComparison,
} from './matrices.ts';
import type { Minimiser, Ordering, Parameters, Stage, Status, Triplets } from './module.ts';

/** What the solver needs of a scene. */
export interface Problem {
  /** #V×3, m. */
  V: Float64Array;
  /** #E×2. */
  E: Int32Array;
  /** #V, kg. */
  m: Float64Array;
}

export interface Pins {
  /** #pinned, indices into the rows of V. */
  pinned: Int32Array;
  /** #pinned×3, m: where each is held. */
  targets: Float64Array;
}

/** Springs of rest length 0, each from a vertex to a point of its own: what a pointer does that holds on to a surface. */
export interface Pull {
  /** #pulled, indices into the rows of V. */
  vertices: Int32Array;
  /** #pulled×3, m. */
  targets: Float64Array;
  /** N/m, of each. */
  stiffness: number;
}

/** Where the cursor goes. `stay` shows the same place again, under what has changed since. */
export type Command =
  | { kind: 'stay' }
  | { kind: 'play'; steps: number }
  | { kind: 'seek'; half_step: number }
  | { kind: 'next_half_step' }
  | { kind: 'previous_half_step' }
  | { kind: 'next_step' }
  | { kind: 'previous_step' }
  /** To accept of another time step: an earlier one, or no farther back than is remembered; a later one is computed on the way. */
  | { kind: 'go_to_step'; step: number }
  | { kind: 'reset' };

/** Every request carries all the settings: the worker keeps none that the page could lose or contradict. */
export interface Request {
  parameters: Parameters;
  pins: Pins;
  command: Command;
  selectedVertex: number | null;
  /** Trace this time step to its end, so that the plot shows where the iteration is going. */
  wholeTrace: boolean;
  /** Measure what an iteration takes. */
  profile: boolean;
}

/** The time step that the solver stands in, solved by another method. */
export interface MethodRequest {
  method: Minimiser;
  iterations: number;
  /** Fewer iterations where these would take longer than about this, ms. */
  patience_ms: number;
}

/** Its way down from p^t: of every iterate p^k, k = 0, 1, …, */
export interface MethodRun {
  method: Minimiser;
  /** E(p^k) − E(p^0), J, */
  change: Float64Array;
  /** and ‖∂E/∂p^k‖∞ of the vertices that are free to move, N. */
  gradient: Float64Array;
  /** and what `stop_decrease` is compared with, (E(p^{k−1}) − E(p^k)) / max(1 J, |E(p^k)|); NaN for k = 0. */
  decrease: Float64Array;
  /** Whether it ended because E falls no further: its last iteration then changed nothing. */
  converged: boolean;
  /** Wall-clock ms of one iteration, on average. */
  milliseconds: number;
}

/** Enough to put a new solver exactly where this one stood. Arrays are #V×3, m. */
export interface Checkpoint {
  step: number;
  half_step: number;
  p_curr: Float64Array;
  p_prev: Float64Array;
}

export type Outcome<T> = { ok: true; value: T } | { ok: false; status: Status };

export interface Reply {
  frame: Frame;
  checkpoint: Checkpoint;
}

export interface Opened extends Reply {
  /** #E, m: rest lengths. */
  r: Float64Array;
}

/** E(p) of a time step and its terms, J, at a p of the page's choice, and ∂E/∂p there, #V×3, N. */
export interface Evaluation {
  objective: number;
  potential: number;
  inertia: number;
  external: number;
  pin: number;
  gradient: Float64Array;
}

/** What of the open problem only a small scene can show whole. */
export interface Inspection {
  /** #V×3, m: p^t and p^{t−Δt}. */
  p_curr: Float64Array;
  p_prev: Float64Array;
  /** #V, kg: in use. */
  m: Float64Array;
  A: Triplets;
  M: Triplets;
  C: Triplets;
  Q: Triplets;
  /** #V: every row of Q p = b, at the cursor. */
  equations: VertexEquation[];
  /** #V×3, m: where the forces at p^t would carry each vertex. */
  explicitStep: Float64Array;
  /** 1+K, each #V×3, m: p at predict and after each iteration of the whole time step. */
  iterates: Float64Array[];
  /** One for each point asked about. */
  evaluations: Evaluation[];
}

/** What a long request is at. */
export interface Progress {
  stage: Stage;
  /** 0 … 1 of the stage; 0 also where that cannot be told. */
  fraction: number;
  /** Of the scene at work. */
  vertices: number;
}

/** What the worker posts from inside a request, between comlink's messages: a sign of life that needs no answer. */
export interface ProgressMessage {
  progress: Progress;
}

/** The worker's side, as comlink exposes it. */
export interface SolverService {
  /** Compiles the module. Call once, before anything else. */
  start(wasmBinary: ArrayBuffer): Promise<void>;
  /** Opens a problem, at rest or where `from` says, and runs the request there. On failure the problem open before stays. */
  open(problem: Problem, request: Request, from: Checkpoint | null): Promise<Outcome<Opened>>;
  run(request: Request): Promise<Outcome<Reply>>;
  /** Leaves the solver where it stands. */
  compare(request: MethodRequest): Promise<Outcome<MethodRun>>;
  /** Changes nothing. Each point is #V×3, m. */
  inspect(points: readonly Float64Array[]): Promise<Inspection>;
  /** These four look at the open problem and leave the solver where it stands. */
  matrices(): Promise<Matrices>;
  linearlyImplicit(): Promise<LinearlyImplicitMatrices>;
  elimination(ordering: Ordering): Promise<Elimination>;
  eliminationStep(request: EliminationStepRequest): Promise<Outcome<EliminationStep>>;
  compareStorage(): Promise<StorageComparison>;
}
