import { expect, test } from 'vitest';
import type { Parameters } from '../../web/src/solver/module.ts';
import type { Checkpoint } from '../../web/src/solver/protocol.ts';
import { SideBySideSession, type Variant } from '../../web/src/solver/side_by_side.ts';
import { expectOk, openSimulation, solver } from '../support/open_simulation.ts';
import { chain, net, usualParameters } from '../support/small_scenes.ts';

const scene = net(4);
const held = { pinned: scene.pinned, targets: Float64Array.from([0, 0.5, 0, 0.375, 0.5, 0]) };
const variant = (change: Partial<Parameters>): Variant => ({
  parameters: { ...usualParameters, ...change },
  substeps: 1,
  mistake: 'none',
});
const variants = [1, 10, 50].map((iterations) => variant({ iterations }));

function opened(list: readonly Variant[], from: Checkpoint | null = null) {
  const session = new SideBySideSession(solver);
  const outcome = session.open(scene, list, held, from);
  if (!outcome.ok) throw new Error(outcome.status.code);
  return { session, ...outcome.value };
}

test('every variant moves as it would alone', () => {
  const { session } = opened(variants);
  const states = session.run(held, null, 7);
  variants.forEach(({ parameters }, at) => {
    const alone = openSimulation(scene, parameters);
    expectOk(alone.set_pins(held.pinned, held.targets));
    for (let step = 0; step < 7; step++) expectOk(alone.step());
    expect(states[at].p).toEqual(alone.p());
    expect(states[at].energies).toHaveLength(7);
    const { external, ...energy } = alone.energy();
    expect(states[at].energies[6]).toMatchObject(energy);
    // Gravity's is counted from the rest positions: the same numbers summed in another order.
    const atRest = scene.m.reduce((sum, mass, i) => sum + parameters.gravity * mass * scene.V[3 * i + 1], 0);
    expect(states[at].energies[6].external).toBeCloseTo(external - atRest, 10);
  });
});

test('all begin where the checkpoint’s time step begins', () => {
  const alone = openSimulation(scene, usualParameters);
  for (let step = 0; step < 5; step++) expectOk(alone.next_step());
  const from = { step: 6, half_step: 3, p_curr: alone.p_curr().slice(), p_prev: alone.p_prev().slice() };
  const { session, states } = opened([variants[1]], from);
  expect(states[0].p).toEqual(from.p_curr);
  expectOk(alone.step());
  expect(session.run(held, null, 1)[0].p).toEqual(alone.p());
});

test('a stiff chain, let go, swings down the slower the fewer the iterations: an unfinished solve looks damped', () => {
  const horizontal = chain(6);
  const pin = { pinned: horizontal.pinned, targets: new Float64Array(3) };
  const session = new SideBySideSession(solver);
  const stiff = variants.map(({ parameters }) => variant({ ...parameters, k: 1e5 }));
  expect(session.open(horizontal, stiff, pin, null).ok).toBe(true);
  const heights = session.run(pin, null, 10).map(({ energies }) => energies[9].external);
  expect(heights[0]).toBeGreaterThan(heights[1]);
  expect(heights[1]).toBeGreaterThan(heights[2]);
});

test('what is refused says so, and which parameter', () => {
  const outcome = new SideBySideSession(solver).open(scene, [variants[0], variant({ k: -1 })], held, null);
  expect(outcome).toMatchObject({ ok: false, status: { code: 'not_positive', field: 'k', value: -1 } });
});

test('a variant with a mistake that diverges says where and stands still, while the right one goes on', () => {
  const usual = variants[1].parameters;
  const { session, states } = opened([variants[1], { parameters: usual, substeps: 1, mistake: 'times-swapped' }]);
  expect(states.map(({ cost }) => cost?.storedInQ)).toEqual([undefined, 16 + 2 * 33]);
  const [right, wrong] = session.run(held, null, 100);
  expect(right).toMatchObject({ failure: null, cost: null });
  expect(right.energies).toHaveLength(100);
  expect(wrong.failure?.status).toMatchObject({ code: 'diverged', field: 'p' });
  expect(wrong.failure).toMatchObject({ step: wrong.energies.length + 1, half_step: 2 });
  expect(wrong.p.every(Number.isFinite)).toBe(true);
  const [, later] = session.run(held, null, 1);
  expect(later).toMatchObject({ energies: [], failure: wrong.failure, p: wrong.p });
});
