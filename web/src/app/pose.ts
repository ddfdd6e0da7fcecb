import type { Followed } from '../solver/follow_targets.ts';
import type { IkAnswer } from '../solver/inverse_kinematics.ts';

/** How an arm stands. */
export interface Pose {
  /** #joints×3, m. */
  x: Float64Array;
  /** #joints×4, (x, y, z, w): of each joint against the one before. */
  q: Float64Array;
}

/** How the arm stands at one of the targets that it has followed. */
export function poseAt({ x, q, errors }: Followed, place: number): Pose {
  const joints = x.length / 3 / errors.length;
  return {
    x: x.subarray(3 * joints * place, 3 * joints * (place + 1)),
    q: q.subarray(4 * joints * place, 4 * joints * (place + 1)),
  };
}

export function countEvents(answer: IkAnswer): number {
  return answer.events.length / 3;
}

/** After so many of the answer's events; the last is where it ended. */
export function poseAfter(answer: IkAnswer, events: number): Pose {
  if (events === countEvents(answer)) return { x: answer.x, q: answer.q };
  if (events === 0) return { x: answer.start_x, q: answer.start_q };
  const joints = answer.x.length / 3;
  return {
    x: answer.event_x.subarray(3 * joints * (events - 1), 3 * joints * events),
    q: answer.event_q.subarray(4 * joints * (events - 1), 4 * joints * events),
  };
}
