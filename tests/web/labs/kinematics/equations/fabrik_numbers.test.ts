import { describe, expect, it } from 'vitest';
import { passRows, rootGap } from '../../../../../web/src/labs/kinematics/equations/fabrik_numbers.ts';
import { momentAt } from '../../../../../web/src/labs/kinematics/trace/moment.ts';
import { armSearch, linksOf } from '../../../../support/arm_search.ts';

/** Two links of 1 m that hang from the origin, and a target at (1, −1, 0), to which the first pass leads by hand. */
const search = armSearch({ links: linksOf(1, 1), root: [0, 0, 0], target: [1, -1, 0], method: 'fabrik' });

describe('the backward pass', () => {
  const moment = momentAt(search, 1);
  const rows = passRows(moment);

  it('goes from the end effector, which it puts on the target, to the root', () => {
    expect(rows.map(({ joint }) => joint)).toEqual([2, 1, 0]);
    expect(rows[0].x).toEqual([1, -1, 0]);
    expect(rows[0].moved).toBeCloseTo(Math.SQRT2, 14); // from (0, −2, 0)
  });

  it('leaves joint 1, which is 1 m from the target already, and the root', () => {
    expect(rows[1].x).toEqual([0, -1, 0]);
    expect(rows[1].moved).toBe(0);
    expect(rootGap(search, moment)).toBe(0);
  });

  it('knows positions only', () => expect(rows.map(({ turned }) => turned)).toEqual([null, null, null]));
});

describe('the forward pass', () => {
  const rows = passRows(momentAt(search, 2));

  it('goes from the root on', () => expect(rows.map(({ joint }) => joint)).toEqual([0, 1, 2]));

  it('turns joint 1 by a quarter turn, and the root by nothing', () => {
    expect(rows[0].turned).toBeCloseTo(0, 14);
    expect(rows[1].turned).toBeCloseTo(Math.PI / 2, 14);
    expect(rows[2].turned).toBeNull();
  });
});

it('the root is pulled away by as much as the pass moves it', () => {
  const lab = armSearch({ method: 'fabrik' });
  const moment = momentAt(lab, 1);
  expect(rootGap(lab, moment)).toBe(passRows(moment)[4].moved);
  expect(rootGap(lab, moment)).toBeGreaterThan(0.1);
});

it('limits turn back what is beyond them, and nothing else', () => {
  const links = [1, 1, 1].map((length) => ({ length, bend: 30 }));
  const held = armSearch({ links, root: [0, 0, 0], target: [1, -2, 0], method: 'fabrik', iterations: 1 });
  const moment = momentAt(held, 3);
  expect(moment.kind).toBe('limit');
  const beyond = moment.before.q.map((_, at) => moment.before.q[at] - moment.after.q[at]);
  for (const { joint, turned } of passRows(moment).slice(0, 3)) {
    const changed = beyond.subarray(4 * joint, 4 * joint + 4).some((part) => Math.abs(part) > 1e-12);
    expect((turned ?? 0) > 1e-11, `joint ${joint}`).toBe(changed);
  }
  expect(passRows(moment).some(({ turned }) => (turned ?? 0) > 0.1)).toBe(true);
});
