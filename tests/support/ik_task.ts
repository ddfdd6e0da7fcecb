import type { IkTask } from '../../web/src/solver/inverse_kinematics.ts';

/** m: of the lab's chain. */
export const labLinks: readonly number[] = [0.8, 0.4, 0.2, 1.2];

/** For the lab's chain, hanging down from a height of 1.7 m, or for one with other links. */
export function ikTask(given: Partial<IkTask> = {}, links = labLinks): IkTask {
  return {
    offsets: Float64Array.from(links.flatMap((length) => [0, -length, 0])),
    root: Float64Array.of(0, 1.7, 0),
    start: new Float64Array(),
    start_q: new Float64Array(),
    target: Float64Array.of(0.6, 0, 0),
    method: 'ccd',
    iterations: 100,
    epsilon: 1e-4,
    turn_limit: Math.PI,
    bend_limits: new Float64Array(),
    precision: 'double',
    ...given,
  };
}

const turns = Array.from({ length: 200 }, (_, at) => (2 * Math.PI * at) / 200);

/** The lab's circle and heart on the plane y = 0: 200 targets each, #T×3, m. */
export const circle = Float64Array.from(turns.flatMap((t) => [0.6 * Math.cos(t), 0, 0.6 * Math.sin(t)]));
export const heart = Float64Array.from(
  turns.flatMap((t) => {
    const radius = 0.5 * (1 - Math.sin(t));
    return [radius * Math.cos(t), 0, radius * Math.sin(t)];
  }),
);
