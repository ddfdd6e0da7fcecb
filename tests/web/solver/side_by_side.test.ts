import { describe, expect, test } from 'vitest';
import { farthest } from '../../../web/src/solver/farthest.ts';
import type { Parameters } from '../../../web/src/solver/module.ts';
import { SideBySideSession, type Variant } from '../../../web/src/solver/side_by_side.ts';
import { expectOk, openSimulation, solver } from '../../support/open_simulation.ts';
import { net, usualParameters } from '../../support/small_scenes.ts';

const scene = net(4);
const held = { pinned: scene.pinned, targets: Float64Array.from([0, 0.5, 0, 0.375, 0.5, 0]) };
const fast: Parameters = { ...usualParameters, path: 'fast' };
const variant = (change: Partial<Parameters>, substeps = 1): Variant => ({
  parameters: { ...fast, ...change },
  substeps,
  mistake: 'none',
});
const [few, many] = [variant({ iterations: 1 }), variant({ iterations: 50 })];

function opened(variants: readonly Variant[]): SideBySideSession {
  const session = new SideBySideSession(solver);
  expect(session.open(scene, variants, held, null).ok).toBe(true);
  return session;
}

function changed(session: SideBySideSession, variants: readonly Variant[]) {
  const outcome = session.change(variants);
  if (!outcome.ok) throw new Error(outcome.status.code);
  return outcome.value;
}

/** m: positions are of the order of 1 m, and a velocity is a difference of them over Δt, multiplied by Δt again. */
const rounding = 1e-14;

test('a time step of three substeps is three steps of a third of Δt', () => {
  const alone = openSimulation(scene, { ...fast, delta_t: fast.delta_t / 3 });
  expectOk(alone.set_pins(held.pinned, held.targets));
  for (let step = 0; step < 6; step++) expectOk(alone.step());
  const [state] = opened([variant({}, 3)]).run(held, null, 2);
  expect(state.p).toEqual(alone.p());
  expect(state.energies).toHaveLength(2);
  const { kinetic, springs } = alone.energy();
  expect(state.energies[1]).toMatchObject({ kinetic, springs });
});

describe('a change', () => {
  test('of what does not matter leaves the motion as it would have been', () => {
    const [session, undisturbed] = [opened([many]), opened([many])];
    session.run(held, null, 5);
    undisturbed.run(held, null, 5);
    const wider = variant({ iterations: 51 });
    changed(session, [wider]);
    changed(session, [many]);
    const [p, q] = [session, undisturbed].map((one) => one.run(held, null, 3)[0].p);
    // A solve carries the rounding of its start on by no more than its condition, κ of the order of 10.
    expect(farthest(p, q)).toBeLessThan(100 * rounding);
  });

  test('of Δt keeps positions and velocities', () => {
    const session = opened([many]);
    const before = [1, 2].map(() => session.run(held, null, 5)[0]);
    const { p, energies } = before[1];
    const [state] = changed(session, [variant({ iterations: 50, delta_t: fast.delta_t / 100 }, 2)]).states;
    expect(state.p).toEqual(p);
    // In so short a time the kinetic energy changes by force times velocity, a hundredth of what it does in a whole step.
    const [{ energies: after }] = session.run(held, null, 1);
    const change = Math.abs(energies[4].kinetic - energies[3].kinetic);
    expect(Math.abs(after[0].kinetic - energies[4].kinetic)).toBeLessThan(0.1 * change);
  });

  test('gives a new variant the first one’s motion, and says who goes on from whom', () => {
    const session = opened([few, many]);
    const [first] = session.run(held, null, 4);
    const { states, from } = changed(session, [few, many, variant({ iterations: 10 })]);
    expect(from).toEqual([0, 1, null]);
    expect(states[2].p).toEqual(first.p);
    const same = changed(session, [few, many, few]);
    expect(same.from).toEqual([0, 1, 2]);
    const [one, , third] = session.run(held, null, 2);
    expect(farthest(one.p, third.p)).toBeLessThan(100 * rounding);
  });

  test('gives it the motion of one that has not exploded, if there is one', () => {
    const session = opened([variant({ method: 'forward-euler' }), many]);
    const states = session.run(held, null, 1000);
    expect(states.map(({ failure }) => failure === null)).toEqual([false, true]);
    const { states: after, from } = changed(session, [variant({ method: 'forward-euler' }), many, few]);
    expect(from).toEqual([0, 1, null]);
    expect(after[2].p).toEqual(states[1].p);
  });

  test('that drops the first leaves the others where they are', () => {
    const session = opened([few, many]);
    const [, second] = session.run(held, null, 4);
    const { states, from } = changed(session, [many]);
    expect(from).toEqual([1]);
    expect(states[0].p).toEqual(second.p);
  });

  test('that is refused changes nothing', () => {
    const [session, undisturbed] = [opened([few, many]), opened([few, many])];
    session.run(held, null, 4);
    undisturbed.run(held, null, 4);
    const outcome = session.change([variant({ k: 2e3 }), variant({ k: -1 }), many]);
    expect(outcome).toMatchObject({ ok: false, status: { code: 'not_positive', field: 'k', value: -1 } });
    const [p, q] = [session, undisturbed].map((one) => one.run(held, null, 3).map((state) => state.p));
    expect(p[1]).toEqual(q[1]);
    expect(farthest(p[0], q[0])).toBeLessThan(100 * rounding);
  });
});

describe('the same instant', () => {
  const newton = variant({ method: 'newton', iterations: 1000 });

  test('finds Newton’s method at the minimiser and few iterations farther from it than many', () => {
    const session = opened([few, many, newton]);
    session.run(held, null, 5);
    const outcome = session.sameInstant(2, held, null);
    if (!outcome.ok) throw new Error(outcome.status.code);
    const [far, near, exact] = outcome.value.errors;
    expect(exact).toEqual({ distance: 0, objective: 0 }); // the same steps, bit for bit
    expect(far?.distance).toBeGreaterThan(near?.distance ?? Number.POSITIVE_INFINITY);
    expect(near?.objective).toBeGreaterThan(-1e-11); // E is of the order of 1e3 J, and rounded
    expect(far?.objective).toBeGreaterThan(near?.objective ?? Number.POSITIVE_INFINITY);
    expect(outcome.value.states.map(({ energies }) => energies.length)).toEqual([1, 1, 1]);
  });

  test('starts from the leader’s motion, whoever leads', () => {
    const session = opened([few, many]);
    session.run(held, null, 5);
    const alone = openSimulation(scene, many.parameters);
    expectOk(alone.set_pins(held.pinned, held.targets));
    for (let step = 0; step < 6; step++) expectOk(alone.step());
    const outcome = session.sameInstant(1, held, null);
    if (!outcome.ok) throw new Error(outcome.status.code);
    expect(farthest(outcome.value.states[1].p, alone.p())).toBeLessThan(100 * rounding);
    expect(farthest(outcome.value.states[0].p, alone.p())).toBeGreaterThan(1e-6);
  });
});

describe('a pull', () => {
  const pull = { vertices: Int32Array.of(15), targets: Float64Array.of(2, -1, 1), stiffness: 500 };

  test('draws all variants to its point, and lets them go', () => {
    const session = opened([variant({ method: 'linearly-implicit' }), many]);
    const distances = (list: readonly { p: Float64Array }[]) =>
      list.map(({ p }) => farthest(p.subarray(45, 48), pull.targets));
    const before = distances(session.run(held, null, 5));
    const pulled = distances(session.run(held, pull, 5));
    const after = distances(session.run(held, null, 40));
    for (const at of [0, 1]) {
      expect(pulled[at]).toBeLessThan(before[at]);
      expect(after[at]).toBeGreaterThan(pulled[at]);
    }
  });

  test('is part of the E(p) that the same instant minimises', () => {
    const session = opened([variant({ method: 'newton', iterations: 1000 }), few]);
    session.run(held, pull, 3);
    const outcome = session.sameInstant(0, held, pull);
    if (!outcome.ok) throw new Error(outcome.status.code);
    expect(outcome.value.errors[0]?.distance).toBeLessThan(rounding * 100);
    expect(outcome.value.errors[1]?.objective).toBeGreaterThan(0);
  });
});

describe('an explicit method', () => {
  const forward = variant({ method: 'forward-euler' });

  test('that explodes says so and stands still, while others go on; other settings let it go on', () => {
    const session = opened([forward, many]);
    const states = session.run(held, null, 1000);
    const { failure, p, energies } = states[0];
    expect(failure?.status.code).toBe('unstable');
    expect(failure?.step).toBe(energies.length + 1);
    expect(p.every(Number.isFinite)).toBe(true);
    expect(states[1].failure).toBeNull();
    const { states: after } = changed(session, [many, many]);
    expect(after.map((state) => state.failure)).toEqual([null, null]);
  });

  test('keeps its velocity, which its last move does not tell, when its settings change', () => {
    const [session, undisturbed] = [opened([forward]), opened([forward])];
    session.run(held, null, 3);
    undisturbed.run(held, null, 3);
    changed(session, [variant({ method: 'forward-euler', iterations: 7 })]); // which it does not heed
    const [p, q] = [session, undisturbed].map((one) => one.run(held, null, 2)[0].p);
    expect(farthest(p, q)).toBeLessThan(100 * rounding);
  });

  test('is stable with enough substeps', () => {
    const session = opened([variant({ method: 'symplectic-euler' }, 8)]);
    expect(session.run(held, null, 300)[0].failure).toBeNull();
  });
});
