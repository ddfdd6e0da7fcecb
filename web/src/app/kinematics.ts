import { type CurveChoice, curveLimits } from '../curves/curve_choice.ts';
import type { Sampling } from '../curves/sampling.ts';
import type { IkMethod, IkTask } from '../solver/inverse_kinematics.ts';

/** From one joint to the next; at rest it hangs straight down. */
export interface Link {
  /** m. */
  length: number;
  /** Degrees: how far its joint may bend it from the direction of the link before. Null: as far as it likes. */
  bend: number | null;
}

export type Point3 = readonly [x: number, y: number, z: number];

/** What the kinematics lab shows: part of the saved state. */
export interface KinematicsSettings {
  /** From the root to the end effector. */
  links: readonly Link[];
  /** m. */
  root: Point3;
  /** Whether the arm reaches for the target that the reader moves, or draws the curve. */
  mode: 'aim' | 'draw';
  /** m. */
  target: Point3;
  curve: CurveChoice;
  sampling: Sampling;
  /** How many points the curve is drawn with. */
  points: number;
  method: IkMethod;
  precision: IkTask['precision'];
  /** The most for one target. */
  iterations: number;
  /** m. */
  epsilon: number;
  /** Degrees: how far a joint may turn between two targets. Null: as far as it likes. */
  turn: number | null;
}

/** What a link may ask for. */
export const kinematicsLimits = {
  links: { min: 1, max: 20 },
  length: { min: 0.01, max: 5 }, // m
  bend: { min: 0, max: 180 }, // degrees
  coordinate: { min: -20, max: 20 }, // m
  ...curveLimits,
  hand: { strokes: 100, points: 3000 },
  iterations: { min: 1, max: 1000 },
  epsilon: { min: 1e-12, max: 0.1 }, // m
  turn: { min: 0.1, max: 180 }, // degrees
} as const;

/** The lab's chain, which reaches the plane y = 0 that it draws on. [P] */
export const defaultKinematics: KinematicsSettings = {
  links: [0.8, 0.4, 0.2, 1.2].map((length) => ({ length, bend: null })),
  root: [0, 1.7, 0],
  mode: 'draw',
  target: [0.6, 0.3, 0.4],
  curve: { kind: 'heart' },
  sampling: 'arc-length',
  points: 100,
  method: 'ccd',
  precision: 'double',
  iterations: 100,
  epsilon: 1e-4,
  turn: null,
};

const radians = Math.PI / 180;

/** A search for the settings' target, from a chain that hangs down unless something else is said. */
export function taskOf(settings: KinematicsSettings): IkTask {
  const { links, root, target, method, precision, iterations, epsilon, turn } = settings;
  return {
    offsets: Float64Array.from(links.flatMap(({ length }) => [0, -length, 0])),
    root: Float64Array.from(root),
    start: new Float64Array(),
    start_q: new Float64Array(),
    target: Float64Array.from(target),
    method,
    iterations,
    epsilon,
    turn_limit: (turn ?? 180) * radians,
    bend_limits: links.some(({ bend }) => bend !== null)
      ? Float64Array.from(links, ({ bend }) => (bend ?? 180) * radians)
      : new Float64Array(),
    precision,
  };
}

/** m: the length of the stretched arm. */
export function reachOf({ links }: Pick<KinematicsSettings, 'links'>): number {
  return links.reduce((sum, { length }) => sum + length, 0);
}
