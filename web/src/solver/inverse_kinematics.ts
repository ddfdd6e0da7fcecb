/** Hand-written types of the module's inverse kinematics; tests/wasm/inverse_kinematics.test.ts holds them to the real one. */

/** The names of Method in wasm/core/kinematics/inverse_kinematics.h, same spelling, same order. */
export const ikMethods = ['ccd', 'fabrik', 'least-squares'] as const;
export type IkMethod = (typeof ikMethods)[number];

/** The names of Outcome in wasm/core/kinematics/solution.h, likewise. */
export const ikOutcomes = ['CONVERGED', 'STALLED', 'UNREACHABLE', 'MAX_ITERATIONS'] as const;
export type IkOutcome = (typeof ikOutcomes)[number];

/** A chain of joints, where it begins, and where its end effector is to go. */
export interface IkTask {
  /** #links×3, m: from each joint to the next as long as nothing turns. */
  offsets: Float64Array;
  /** #3, m. */
  root: Float64Array;
  /** #joints×3, m, of which only the directions count: the links keep their lengths. Empty: nothing is turned. */
  start: Float64Array;
  /** #3, m. */
  target: Float64Array;
  method: IkMethod;
  /** The most; one of CCD turns every joint once, one of FABRIK passes backward and forward. */
  iterations: number;
  /** m: how near is near enough. */
  epsilon: number;
  /** Single precision takes the angle between two vectors from its cosine, as graphics libraries do, and so knows none below about 5e-4 rad. */
  precision: 'double' | 'single';
}

/** What happened last at an event: one joint turned (CCD), a pass was made (FABRIK), all joints turned at once (least squares). */
export const ikEventKinds = ['joint', 'backward', 'forward', 'all'] as const;

/** Copies, in doubles whatever the precision. */
export interface IkAnswer {
  outcome: IkOutcome;
  /** Made. */
  iterations: number;
  /** m: between end effector and target. */
  error: number;
  /** #joints×3, m. */
  x: Float64Array;
  /** #joints×4, (x, y, z, w): the rotation of each joint against the one before. */
  q: Float64Array;
  /** #iterations, m: the error after each. */
  errors: Float64Array;
  /** #events×3: iteration from 1, index into ikEventKinds, the joint or −1; and #events×#joints×3, m, where the joints were then. */
  events: Int32Array;
  event_x: Float64Array;
}
