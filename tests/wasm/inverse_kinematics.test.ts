import fc from 'fast-check';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { type Followed, followTargets } from '../../web/src/solver/follow_targets.ts';
import {
  type IkAnswer,
  type IkTask,
  ikEventKinds,
  ikMethods,
  ikOutcomes,
} from '../../web/src/solver/inverse_kinematics.ts';
import { circle, heart, ikTask, labLinks } from '../support/ik_task.ts';
import { anyStatus, solver } from '../support/open_simulation.ts';

function task(target: readonly number[], given: Partial<IkTask> = {}, links: readonly number[] = labLinks): IkTask {
  return ikTask({ target: Float64Array.from(target), ...given }, links);
}

function solve(given: IkTask): IkAnswer {
  const { status, answer } = solver.inverse_kinematics(given);
  expect(status).toMatchObject({ code: 'ok' });
  return answer;
}

const joint = (x: Float64Array, i: number) => new Vector3(x[3 * i], x[3 * i + 1], x[3 * i + 2]);

function linkLengths(x: Float64Array): number[] {
  return Array.from({ length: x.length / 3 - 1 }, (_, i) => joint(x, i).distanceTo(joint(x, i + 1)));
}

/** One target after the other, each from the pose before. */
function follow(targets: Float64Array, given: Partial<IkTask>): Followed {
  const followed = followTargets(solver, ikTask(given), targets);
  if (!followed.ok) throw new Error(followed.status.code);
  return followed.value;
}

test('the names are those of the interface, and a call returns what it says', () => {
  expect(solver.ik_outcomes()).toEqual(ikOutcomes);
  expect(solver.ik_methods()).toEqual(ikMethods);
  const doubles = expect.any(Float64Array);
  const indices = expect.any(Int32Array);
  expect(solver.inverse_kinematics(task([0.3, 0, 0]))).toEqual({
    status: anyStatus,
    answer: {
      outcome: 'CONVERGED',
      iterations: expect.any(Number),
      error: expect.any(Number),
      start_x: doubles,
      start_q: doubles,
      x: doubles,
      q: doubles,
      errors: doubles,
      events: indices,
      event_x: doubles,
      event_q: doubles,
    },
  });
});

describe.each(ikMethods)('%s', (method) => {
  test('reaches the lab’s circle and heart, within its usual number of iterations', () => {
    const most = { ccd: 25, fabrik: 8, 'least-squares': 8 }[method];
    for (const curve of [circle, heart]) {
      const { outcomes, errors, iterations } = follow(curve, { method });
      expect(new Set(outcomes)).toEqual(new Set(['CONVERGED']));
      expect(Math.max(...errors)).toBeLessThanOrEqual(1e-4);
      expect(Math.max(...iterations)).toBeLessThanOrEqual(most);
    }
  });

  test('keeps the links’ lengths, holds the root, and its joints are what its rotations make of the chain', () => {
    const answer = solve(task([0.5, 0.9, -0.7], { method }));
    linkLengths(answer.x).forEach((length, i) => {
      expect(Math.abs(length - labLinks[i])).toBeLessThan(1e-12);
    });
    expect([...answer.x.subarray(0, 3)]).toEqual([0, 1.7, 0]);
    // The same by 4×4 matrices: T(x_0) Rot(q_0) T(o_1) Rot(q_1) …
    const matrix = new Matrix4().makeTranslation(0, 1.7, 0);
    for (let i = 0; i < labLinks.length; i++) {
      const [x, y, z, w] = answer.q.subarray(4 * i);
      matrix.multiply(new Matrix4().makeRotationFromQuaternion(new Quaternion(x, y, z, w)));
      matrix.multiply(new Matrix4().makeTranslation(0, -labLinks[i], 0));
      expect(new Vector3().setFromMatrixPosition(matrix).distanceTo(joint(answer.x, i + 1))).toBeLessThan(1e-12);
    }
  });

  test('points a straight arm at what is too far, without trembling as the target moves on', () => {
    const [first, second] = [3, 3.001].map((x) => solve(task([x, 1.7, 0], { method })));
    for (const { outcome, iterations, error, x } of [first, second]) {
      expect([outcome, iterations]).toEqual(['UNREACHABLE', 0]);
      expect(x.at(-3)).toBeCloseTo(2.6, 12);
      expect(error).toBeGreaterThan(0.39);
    }
    expect(joint(first.x, 4).distanceTo(joint(second.x, 4))).toBeLessThan(1e-12);
  });

  test('has converged where a target is out of reach by less than ε', () => {
    const { outcome, error } = solve(task([2.6 + 5e-5, 1.7, 0], { method }));
    expect(outcome).toBe('CONVERGED');
    expect(error).toBeCloseTo(5e-5, 12);
  });

  test('folds over what is too near for its longest link', () => {
    const { outcome, error, x } = solve(task([0, 1.5, 0], { method }, [0.3, 2, 0.5]));
    // 2 m one way, 0.3 and 0.5 m the other: 1.2 m are the least.
    expect(outcome).toBe('UNREACHABLE');
    expect(error).toBeCloseTo(1.2 - 0.2, 12);
    linkLengths(x).forEach((length, i) => {
      expect(length).toBeCloseTo([0.3, 2, 0.5][i], 12);
    });
  });

  test('bends out of a line on which nothing could turn', () => {
    expect(solve(task([0, 1, 0], { method })).outcome).toBe('CONVERGED');
  });

  test('stalls where rounding keeps it from the target, however short the arm and far its root', () => {
    // Of 10⁶ m a double knows 10⁻¹⁰ m, so that ε = 10⁻¹² m is met by luck only.
    const root = Float64Array.of(1e6, 1e6, 1e6);
    const target = [1e6 + 0.0123456, 1e6, 1e6 + 0.01];
    const { outcome, iterations } = solve(
      task(target, { method, root, epsilon: 1e-12, iterations: 1000 }, [0.01, 0.01]),
    );
    expect(outcome === 'CONVERGED' || outcome === 'STALLED').toBe(true);
    expect(iterations).toBeLessThan(200);
  });

  test('has nothing to do where it starts on the target', () => {
    const { outcome, iterations, errors } = solve(task([0, -0.9, 0], { method }));
    expect([outcome, iterations, errors.length]).toEqual(['CONVERGED', 0, 0]);
  });

  test('tells every event, the last of which is where it ends', () => {
    const { iterations, events, event_x, x, errors, error } = solve(task([0.5, 0.2, 0.3], { method }));
    const kinds = Array.from({ length: events.length / 3 }, (_, e) => ikEventKinds[events[3 * e + 1]]);
    const each = {
      ccd: ['joint', 'joint', 'joint', 'joint'],
      fabrik: ['backward', 'forward'],
      'least-squares': ['all'],
    };
    expect(kinds).toEqual(Array.from({ length: iterations }, () => each[method]).flat());
    expect(errors).toHaveLength(iterations);
    expect(errors.at(-1)).toBe(error);
    // FABRIK's positions become rotations and these positions again: rounding.
    const last = event_x.subarray(event_x.length - x.length);
    last.forEach((value, c) => {
      expect(Math.abs(value - x[c])).toBeLessThan(1e-12);
    });
  });

  test('reaches what can be reached, of any chain from any pose', () => {
    const unit = fc.double({ min: -1, max: 1, noNaN: true });
    const scene = fc.record({
      links: fc.array(fc.double({ min: 0.2, max: 1, noNaN: true }), { minLength: 2, maxLength: 6 }),
      direction: fc.tuple(unit, unit, unit).filter((d) => Math.hypot(...d) > 0.1),
      share: fc.double({ min: 0.1, max: 0.9, noNaN: true }),
    });
    fc.assert(
      fc.property(scene, ({ links, direction, share }) => {
        const reach = links.reduce((sum, length) => sum + length, 0);
        const nearest = Math.max(0, 2 * Math.max(...links) - reach);
        const distance = nearest + share * (reach - nearest);
        const target = direction.map((d, axis) => (axis === 1 ? 1.7 : 0) + (d / Math.hypot(...direction)) * distance);
        const answer = solve(task(target, { method, iterations: 5000 }, links));
        expect(answer.outcome).toBe('CONVERGED');
        linkLengths(answer.x).forEach((length, i) => {
          expect(Math.abs(length - links[i])).toBeLessThan(1e-12);
        });
      }),
      { numRuns: 200 },
    );
  });
});

test('one turn of CCD by hand: the middle joint turns its link, then the root all', () => {
  // Two links of 1 m hang down from the origin; the target lies 1 m to the right of the root, at √2 from the middle joint.
  const given = task([1, 0, 0], { iterations: 1, root: Float64Array.of(0, 0, 0) }, [1, 1]);
  const { events, event_x, outcome } = solve(given);
  expect([...events]).toEqual([1, 0, 1, 1, 0, 0]);
  const half = Math.SQRT1_2;
  const expected = [0, 0, 0, 0, -1, 0, half, half - 1, 0];
  expected.forEach((value, c) => {
    expect(event_x[c]).toBeCloseTo(value, 14);
  });
  // The effector (√½, √½ − 1) is turned onto the x axis, at its distance √(2 − √2) from the root.
  expect(event_x[15]).toBeCloseTo(Math.sqrt(2 - Math.SQRT2), 14);
  expect(event_x[16]).toBeCloseTo(0, 14);
  expect(outcome).toBe('MAX_ITERATIONS');
});

test('in single precision, by the cosine, CCD stalls before it is near enough; FABRIK does not need the angle', () => {
  const [ccd, fabrik] = (['ccd', 'fabrik'] as const).map((method) => follow(circle, { method, precision: 'single' }));
  expect(ccd.outcomes.some((outcome, i) => outcome === 'STALLED' && ccd.errors[i] > 1e-4)).toBe(true);
  expect(Math.max(...ccd.errors)).toBeLessThan(5e-3);
  expect(new Set(fabrik.outcomes)).toEqual(new Set(['CONVERGED']));
});

describe.each(ikMethods)('%s with limits', (method) => {
  const reachable = fc
    .tuple(...Array.from({ length: 3 }, () => fc.double({ min: -1, max: 1, noNaN: true })))
    .filter((d) => Math.hypot(...d) > 0.3 && Math.hypot(...d) < 1)
    .map(([x, y, z]) => [1.2 * x, 1.7 + 1.2 * y, 1.2 * z]);

  /** rad: between joint i's link and the one before, or straight down. */
  const bends = (x: Float64Array) =>
    Array.from({ length: x.length / 3 - 1 }, (_, i) => {
      const before = i === 0 ? new Vector3(0, -1, 0) : joint(x, i).sub(joint(x, i - 1));
      return before.angleTo(joint(x, i + 1).sub(joint(x, i)));
    });

  test('no joint bends its link further than it may, and no link changes its length', () => {
    const limits = fc.array(fc.double({ min: 0.05, max: 3, noNaN: true }), { minLength: 4, maxLength: 4 });
    fc.assert(
      fc.property(reachable, limits, (target, bend_limits) => {
        const answer = solve(task(target, { method, bend_limits: Float64Array.from(bend_limits) }));
        bends(answer.x).forEach((bend, i) => {
          expect(bend).toBeLessThan(bend_limits[i] + 1e-7); // acos near 0 and π knows no more
        });
        linkLengths(answer.x).forEach((length, i) => {
          expect(Math.abs(length - labLinks[i])).toBeLessThan(1e-12);
        });
        expect(['CONVERGED', 'STALLED', 'MAX_ITERATIONS']).toContain(answer.outcome);
      }),
      { numRuns: 100 },
    );
  });

  test('no joint turns further between two targets than it may, and limits that are never met change nothing', () => {
    const most = 0.2; // rad
    fc.assert(
      fc.property(reachable, reachable, (from, to) => {
        const before = solve(task(from, { method }));
        const { q, x } = solve(task(to, { method, start_q: before.q, turn_limit: most }));
        for (let i = 0; i < 5; i++) {
          const [a, b] = [before.q, q].map((all) => new Quaternion().fromArray(all, 4 * i));
          expect(a.angleTo(b)).toBeLessThan(most + 1e-7);
        }
        const free = solve(task(to, { method, start_q: before.q }));
        const wide = solve(task(to, { method, start_q: before.q, bend_limits: new Float64Array(4).fill(Math.PI) }));
        expect(free.x.length).toBe(x.length);
        wide.x.forEach((value, c) => {
          expect(value).toBeCloseTo(free.x[c], 9); // FABRIK's positions pass through rotations either way
        });
      }),
      { numRuns: 100 },
    );
  });

  test('with a turn limit, target after target, the arm gets to where it gets without one', () => {
    let answer = solve(task([0.6, 0, 0], { method }));
    for (let frame = 0; frame < 100; frame++)
      answer = solve(task([-0.6, 0, 0.3], { method, start_q: answer.q, turn_limit: 0.1 }));
    expect(answer.outcome).toBe('CONVERGED');
    let far = solve(task([0.6, 0, 0], { method }));
    for (let frame = 0; frame < 100; frame++)
      far = solve(task([3, 1.7, 0], { method, start_q: far.q, turn_limit: 0.1 }));
    expect(far.outcome).toBe('UNREACHABLE');
    expect(far.x.at(-3)).toBeCloseTo(2.6, 12);
  });

  test('what lies out of reach is unreachable under limits, too, and stiff joints stall', () => {
    const bend_limits = Float64Array.of(0.5, 0.5, 0.5, 0.5);
    expect(solve(task([0, 5, 0], { method, bend_limits })).outcome).toBe('UNREACHABLE');
    const stiff = solve(task([0.6, 0, 0], { method, bend_limits: new Float64Array(4) }));
    expect(stiff.outcome).toBe('STALLED');
    stiff.x.forEach((value, c) => {
      expect(Math.abs(value - stiff.start_x[c])).toBeLessThan(1e-14); // rounding
    });
  });

  test('the events lead from where the search began to where it ended', () => {
    for (const target of [
      [0.5, 0.2, 0.3],
      [0, 1, 0],
      [3, 1.7, 0],
    ]) {
      for (const limits of [{}, { turn_limit: 0.3 }]) {
        const { start_x, start_q, event_x, event_q, events, x, q } = solve(task(target, { method, ...limits }));
        expect(linkLengths(start_x)).toHaveLength(4);
        expect(start_q).toHaveLength(20);
        const last = events.length / 3 - 1;
        x.forEach((value, c) => {
          expect(Math.abs(value - event_x[15 * last + c])).toBeLessThan(1e-12); // as above
        });
        expect([...event_q.subarray(20 * last)]).toEqual([...q]);
      }
    }
  });
});

test.each([
  [task([1, 0, 0], {}, [0.5, 0, 0.5]), { code: 'not_positive', field: 'links', index: 1, value: 0 }],
  [task([0, 1.7, 0]), { code: 'on_root', field: 'target' }],
  // In single precision 1.7 + 1e-9 is 1.7, and 1e-50 is 0.
  [task([0, 1.7 + 1e-9, 0], { precision: 'single' }, [0.2, 0.3, 3]), { code: 'on_root', field: 'target' }],
  [task([1, 0, 0], { precision: 'single' }, [1, 1e-50]), { code: 'not_positive', field: 'links', index: 1 }],
  [task([0, Number.NaN, 0]), { code: 'not_finite', field: 'target' }],
  [task([1, 0, 0], { offsets: new Float64Array() }), { code: 'wrong_length', field: 'links' }],
  [task([1, 0]), { code: 'wrong_length', field: 'target', value: 2 }],
  [task([1, 0, 0], { start: new Float64Array(12) }), { code: 'wrong_length', field: 'start', value: 12 }],
  [task([1, 0, 0], { start: new Float64Array(15) }), { code: 'not_positive', field: 'start', index: 0 }],
  [task([1, 0, 0], { iterations: 0 }), { code: 'not_positive', field: 'iterations', value: 0 }],
  [task([1, 0, 0], { start_q: new Float64Array(4) }), { code: 'wrong_length', field: 'start_q', value: 4 }],
  [task([1, 0, 0], { start_q: new Float64Array(20) }), { code: 'not_positive', field: 'start_q', index: 0 }],
  [task([1, 0, 0], { turn_limit: 0 }), { code: 'not_positive', field: 'turn_limit', value: 0 }],
  [task([1, 0, 0], { bend_limits: Float64Array.of(1) }), { code: 'wrong_length', field: 'bend_limits', value: 1 }],
  [
    task([1, 0, 0], { bend_limits: Float64Array.of(1, 1, -1, 1) }),
    { code: 'negative', field: 'bend_limits', index: 2 },
  ],
  [task([1, 0, 0], { epsilon: 0 }), { code: 'not_positive', field: 'epsilon', value: 0 }],
])('refuses %j', (given, status) => {
  expect(solver.inverse_kinematics(given).status).toMatchObject(status);
});
