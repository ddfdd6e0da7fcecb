import type { Search } from '../../../app/kinematics_session.ts';
import { countEvents, type Pose, poseAfter } from '../../../app/pose.ts';
import { norm, row, subtract, type Vector } from '../../../lib/vector.ts';
import { type IkEventKind, ikEventKinds } from '../../../solver/inverse_kinematics.ts';

/** A place of the cursor inside a search, and what happened last. */
export interface Moment {
  /** How many events have happened. */
  event: number;
  /** What the last of them was; `start` before the first. */
  kind: 'start' | IkEventKind;
  /** From 1; 0 before the first. */
  iteration: number;
  /** That has turned alone. */
  joint: number | null;
  /** Before the last event and after it; the same at the start. */
  before: Pose;
  after: Pose;
}

/** Of what the cursor stands at. */
export function momentAt({ answer }: Search, event: number): Moment {
  const after = poseAfter(answer, event);
  if (event === 0) return { event, kind: 'start', iteration: 0, joint: null, before: after, after };
  const [iteration, kind, joint] = answer.events.subarray(3 * (event - 1), 3 * event);
  return {
    event,
    kind: ikEventKinds[kind],
    iteration,
    joint: joint < 0 ? null : joint,
    before: poseAfter(answer, event - 1),
    after,
  };
}

/** m: from the end effector to the target. */
export function missingAt({ task }: Search, pose: Pose): Vector {
  return subtract(row(task.target, 0), row(pose.x, pose.x.length / 3 - 1));
}

/** m: between end effector and target. */
export function errorAt(search: Search, pose: Pose): number {
  return norm(missingAt(search, pose));
}

/** Where iterations end, as places of the cursor; first 0, last the end. */
export function iterationEnds({ answer }: Search): number[] {
  const count = countEvents(answer);
  const iterationOf = (event: number) => answer.events[3 * (event - 1)];
  const ends = Array.from({ length: count }, (_, at) => at + 1).filter(
    (event) => event === count || iterationOf(event) !== iterationOf(event + 1),
  );
  return [0, ...ends];
}

/** How many iterations have been made at the cursor: 2.5 in the middle of the third. */
export function progressAt(search: Search, { event, iteration }: Moment): number {
  if (iteration === 0) return 0;
  const ends = iterationEnds(search);
  const next = ends.findIndex((end) => end >= event);
  return iteration - 1 + (event - ends[next - 1]) / (ends[next] - ends[next - 1]);
}
