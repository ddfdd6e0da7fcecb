import { expect, it } from 'vitest';
import { questionTargets } from '../../../../../web/src/labs/kinematics/questions/question_targets.ts';

it('the circle’s targets lie 0.6 m around the middle of the floor, each once', () => {
  const targets = questionTargets('circle', 8);
  expect(targets).toHaveLength(24);
  for (let at = 0; at < 24; at += 3) {
    expect(Math.hypot(targets[at], targets[at + 2])).toBeCloseTo(0.6, 14);
    expect(targets[at + 1]).toBe(0);
  }
  const apart = Math.hypot(targets[21] - targets[0], targets[23] - targets[2]);
  expect(apart).toBeCloseTo(2 * 0.6 * Math.sin(Math.PI / 8), 14); // the last one is a step before the first
});

it('the heart begins in its cusp, in the middle', () => {
  expect(Math.hypot(...questionTargets('heart', 60).subarray(0, 3))).toBeCloseTo(0, 14);
});
