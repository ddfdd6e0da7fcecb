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
  /** #joints×4, (x, y, z, w), of any length but 0: the rotations to start from, in place of `start`. Empty: as `start` says. */
  start_q: Float64Array;
  /** #3, m. */
  target: Float64Array;
  method: IkMethod;
  /** The most; one of CCD turns every joint once, one of FABRIK passes backward and forward. */
  iterations: number;
  /** m: how near is near enough. */
  epsilon: number;
  /** rad: how far a joint may end from where it starts. π: as far as it likes. */
  turn_limit: number;
  /** #links, rad: how far joint i may bend its link from where that points at rest, seen from the joint before. Empty: as far as they like. */
  bend_limits: Float64Array;
  /** Single precision takes the angle between two vectors from its cosine, as graphics libraries do, and so knows none below about 5e-4 rad. */
  precision: 'double' | 'single';
}

/** What happened last at an event: one joint turned (CCD), a pass was made or its rotations were held to their limits (FABRIK), all joints turned at once (least squares); a stretched chain was bent a little to begin with, or laid straight towards what it cannot reach. */
export const ikEventKinds = ['joint', 'backward', 'forward', 'all', 'limit', 'straight', 'bend'] as const;
export type IkEventKind = (typeof ikEventKinds)[number];

/** Copies, in doubles whatever the precision. */
export interface IkAnswer {
  outcome: IkOutcome;
  /** Made. */
  iterations: number;
  /** m: between end effector and target. */
  error: number;
  /** #joints×3, m, and #joints×4: where the search began, held to the limits. */
  start_x: Float64Array;
  start_q: Float64Array;
  /** #joints×3, m. */
  x: Float64Array;
  /** #joints×4, (x, y, z, w): the rotation of each joint against the one before. */
  q: Float64Array;
  /** #iterations, m: the error after each. */
  errors: Float64Array;
  /** #events×3: iteration from 1 or 0 before the first, index into ikEventKinds, the joint or −1; #events×#joints×3, m, where the joints were then; #events×#joints×4, their rotations. */
  events: Int32Array;
  event_x: Float64Array;
  /** Of FABRIK's backward pass, which knows only positions, as before it. */
  event_q: Float64Array;
}
