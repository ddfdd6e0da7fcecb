/** What the solver's worker sends to the page: one place in the trace, in arrays the page owns. */

import type { FactorisationReason, StopReason } from './module.ts';

export type Phase = 'predict' | 'local' | 'global' | 'accept';

/** One half-step of the time step's trace. Energies in J, gradient and residual in N, change in m. */
export interface TraceEvent {
  half_step: number;
  phase: Phase;
  /** 0 at predict, k in 1 … K for local(k) and global(k), K at accept. */
  iteration: number;
  /** E(p). */
  objective: number;
  /** Ẽ(p, d): what each half-step minimises in one of its two arguments; E ≤ Ẽ, equal after a local step. */
  surrogate: number;
  potential: number;
  inertia: number;
  external: number;
  pin: number;
  /** ‖∂E/∂p‖∞ of the vertices that are free to move. */
  gradient: number;
  /** ‖Qp − b‖∞ of a global step; NaN elsewhere, and of methods that do not solve Qp = b. */
  residual: number;
  /** max_i ‖p_i − p_before,i‖. */
  change: number;
}

/** The selected vertex's row of Q p = b, b = k Aᵀ d + y, each #3, N, and what kAᵀd is the sum of. */
export interface VertexEquation {
  vertex: number;
  y: number[];
  kAtd: number[];
  b: number[];
  Qp: number[];
  /** #springs of the vertex, ascending; #springs×3, N: what each of them adds to kAᵀd, k d_e where the vertex is its i, −k d_e where it is its j. */
  springs: Int32Array;
  shares: Float64Array;
}

/** ms of one iteration's local step (on the fast path: ∂E/∂p) and of its global step (Q⁻¹). */
export interface Profile {
  local: number;
  global: number;
}

export interface Frame {
  /** Number of the time step being computed, from 1. */
  step: number;
  half_step: number;
  last_half_step: number;
  /** Made in this time step; K as long as its end is not known. */
  iterations: number;
  /** Why it ended; empty as long as that is not known. */
  stopReason: StopReason | '';
  phase: Phase;
  iteration: number;
  /** #V×3, m: the iterate at the cursor, and the one before it. Doubles: exaggeration ×1000 would show single precision's grain. */
  p: Float64Array;
  pBefore: Float64Array;
  /** #E×3, m: the projections; null at predict, where there is none yet. */
  d: Float64Array | null;
  /** #V×3, m: p^t and p^{t−Δt}. */
  pCurr: Float64Array;
  pPrev: Float64Array;
  /** #V×3, m: where inertia and external forces alone would carry each vertex. */
  prediction: Float64Array;
  /** #pinned, and #pinned×3, m: the pins of this frame and where they hold. */
  pinned: Int32Array;
  targets: Float64Array;
  /** The half-steps traced so far in this time step; empty while playing. */
  events: TraceEvent[];
  vertexEquation: VertexEquation | null;
  stiffnessNumber: number;
  factorisations: { count: number; reason: FactorisationReason };
  /** How many earlier time steps can still be gone back to. */
  rememberedSteps: number;
  /** Wall-clock ms the worker spent on the request that made this frame. */
  milliseconds: number;
  /** Null unless the request asked for it. */
  profile: Profile | null;
}
