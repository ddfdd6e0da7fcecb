import { describe, expect, it } from 'vitest';
import { countEvents } from '../../../../../web/src/app/pose.ts';
import { errorAt, iterationEnds, momentAt, progressAt } from '../../../../../web/src/labs/kinematics/trace/moment.ts';
import { ikMethods } from '../../../../../web/src/solver/inverse_kinematics.ts';
import { armSearch } from '../../../../support/arm_search.ts';

const everyMoment = (search: ReturnType<typeof armSearch>) =>
  Array.from({ length: countEvents(search.answer) + 1 }, (_, event) => momentAt(search, event));

describe('momentAt', () => {
  it('begins with the pose that the search starts from, before which nothing happened', () => {
    const search = armSearch();
    const { kind, iteration, joint, before, after } = momentAt(search, 0);
    expect({ kind, iteration, joint }).toEqual({ kind: 'start', iteration: 0, joint: null });
    expect(before).toEqual({ x: search.answer.start_x, q: search.answer.start_q });
    expect(after).toEqual(before);
  });

  it('is joint after joint of CCD, from the last that turns a link to the root', () => {
    const moments = everyMoment(armSearch()).filter(({ iteration }) => iteration === 2);
    expect(moments.map(({ kind, joint }) => [kind, joint])).toEqual([3, 2, 1, 0].map((joint) => ['joint', joint]));
  });

  it('is pass after pass of FABRIK', () => {
    const moments = everyMoment(armSearch({ method: 'fabrik' })).filter(({ iteration }) => iteration === 2);
    expect(moments.map(({ kind, joint }) => [kind, joint])).toEqual([
      ['backward', null],
      ['forward', null],
    ]);
  });

  it('begins where the moment before ended', () => {
    const moments = everyMoment(armSearch({ method: 'least-squares' }));
    for (const [at, { before }] of moments.slice(1).entries()) expect(before.x).toEqual(moments[at].after.x);
  });
});

describe.each(ikMethods)('iterations of %s', (method) => {
  const search = armSearch({ method });
  const { answer } = search;
  const ends = iterationEnds(search);

  it('end where the trace has their error, to the bit but for FABRIK, which recovers rotations from its positions', () => {
    const errors = ends.slice(-answer.iterations).map((event) => errorAt(search, momentAt(search, event).after));
    expect(errors).toHaveLength(answer.errors.length);
    for (const [at, error] of errors.entries()) expect(error).toBeCloseTo(answer.errors[at], 12);
  });

  it('count whole at their ends, and more and more between', () => {
    expect(progressAt(search, momentAt(search, 0))).toBe(0);
    const counted = ends.slice(-answer.iterations).map((event) => progressAt(search, momentAt(search, event)));
    expect(counted).toEqual(Array.from(answer.errors, (_, at) => at + 1));
    const all = everyMoment(search).map((moment) => progressAt(search, moment));
    expect(all).toEqual([...all].sort((a, b) => a - b));
  });
});

it('an arm that hangs on one line with its target is bent first, which is no iteration', () => {
  const search = armSearch({ target: [0, 0, 0] });
  expect(momentAt(search, 1)).toMatchObject({ kind: 'bend', iteration: 0 });
  expect(iterationEnds(search).slice(0, 3)).toEqual([0, 1, 5]);
});
