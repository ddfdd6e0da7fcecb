import { expect, it } from 'vitest';
import type { Search } from '../../../../web/src/app/kinematics_session.ts';
import { ikEventKinds } from '../../../../web/src/solver/inverse_kinematics.ts';
import { momentOf } from '../../../../web/src/views/scene3d/arm_moment.ts';

/** Two joints; the effector's x tells the pose: −1 at the start, 1 after the first event, … */
const pose = (x: number) => [0, 0, 0, x, 0, 0];
const answer = {
  start_x: Float64Array.from(pose(-1)),
  events: Int32Array.from(
    (['joint', 'joint', 'backward', 'forward'] as const).flatMap((kind) => [1, ikEventKinds.indexOf(kind), 0]),
  ),
  event_x: Float64Array.from([1, 2, 3, 4].flatMap(pose)),
  event_q: new Float64Array(32),
  x: Float64Array.from(pose(4)),
};
const search = { answer } as unknown as Search;
const turnAt = (event: number) => {
  const { turned } = momentOf(search, event);
  return turned && { joint: turned.joint, from: turned.before[0], to: turned.after[0] };
};

it('tells which joint has turned the effector from where to where', () => {
  expect(turnAt(1)).toEqual({ joint: 0, from: -1, to: 1 });
  expect(turnAt(2)).toEqual({ joint: 0, from: 1, to: 2 });
});

it('has no turn at the start and in passes, of which the backward one leaves the root', () => {
  expect([0, 3, 4].map(turnAt)).toEqual([null, null, null]);
  expect([0, 2, 3, 4].map((event) => momentOf(search, event).detached)).toEqual([false, false, true, false]);
  expect(momentOf(search, 3).ghost).toBe(answer.start_x);
});
