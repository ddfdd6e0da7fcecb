import fc from 'fast-check';
import { expect, test } from 'vitest';
import { type MistakenSimulation, mistakes } from '../../web/src/solver/mistaken_simulation.ts';
import { openMistaken } from '../support/open_mistaken.ts';
import { expectOk, openMoving, solver, anyStatus as status } from '../support/open_simulation.ts';
import { chain, movingScenes, net, usualParameters } from '../support/small_scenes.ts';

const { V, E, m, pinned } = chain(3);
const number = expect.any(Number);
const doubles = expect.any(Float64Array);

/** Every call of the hand-written interface, by the compiler's word, with what the real module returns. */
const calls: { [Name in keyof MistakenSimulation]: [Parameters<MistakenSimulation[Name]>, result: unknown] } = {
  set_scene: [[V, E, m, pinned, usualParameters, 'none'], status],
  set_parameters: [[usualParameters], status],
  set_pins: [[pinned, new Float64Array(3)], status],
  reset: [[], status],
  set_state: [[1, V, V, 0], status],
  step: [[], status],
  step_number: [[], 1],
  half_step: [[], 21],
  last_half_step: [[], 21],
  vertex_count: [[], 3],
  spring_count: [[], 2],
  p: [[], doubles],
  p_curr: [[], doubles],
  p_prev: [[], doubles],
  r: [[], Float64Array.of(0.5, 0.5)],
  m: [[], Float64Array.of(1, 1, 1)],
  objective_at: [
    [V],
    {
      objective: number,
      potential: number,
      inertia: number,
      external: number,
      pin: number,
      damping: number,
      pull: number,
    },
  ],
  energy: [[], { kinetic: number, springs: number, external: number }],
  factorisation_count: [[], 1],
  factorisation_time: [[], number],
  // Three on the diagonal, and two for each spring.
  stored_in_Q: [[], 7],
  nonzeros_of_Q: [[], 7],
  stored_in_L: [[], 5],
  delete: [[], undefined],
};

test('the module has exactly the calls of the interface, and they return what it says', () => {
  const simulation = new solver.MistakenSimulation();
  const { delete: _, ...registered } = calls; // embind gives every class its delete
  expect(Object.keys(solver.MistakenSimulation.prototype).sort()).toEqual(Object.keys(registered).sort());
  for (const [name, [inputs, result]] of Object.entries(calls)) {
    const call = simulation[name as keyof MistakenSimulation] as (...inputs: unknown[]) => unknown;
    expect(call.apply(simulation, inputs), name).toEqual(result);
  }
});

test('the names of the mistakes', () => {
  expect(solver.mistakes()).toEqual([...mistakes]);
});

test('without a mistake it is the trusted plain path, bit for bit', () => {
  fc.assert(
    fc.property(movingScenes, (scene) => {
      const trusted = openMoving(scene);
      const other = openMistaken(scene, scene.parameters, 'none');
      expectOk(other.set_pins(scene.pinned, scene.targets));
      expectOk(other.set_state(1, scene.p_curr, scene.p_prev, 0));
      for (let step = 1; step <= 4; step++) {
        expectOk(trusted.step());
        expectOk(other.step());
        expect(other.step_number()).toBe(trusted.step_number());
        expect(other.p()).toEqual(trusted.p());
        expect(other.p_curr()).toEqual(trusted.p_curr());
        expect(other.p_prev()).toEqual(trusted.p_prev());
        expect(other.energy()).toEqual(trusted.energy());
        expect(other.objective_at(scene.V)).toEqual(trusted.objective_at(scene.V));
      }
      // A parameter, the order of the pins and a pin moved in mid-motion.
      const parameters = { ...scene.parameters, k: 2 * scene.parameters.k, iterations: 3 };
      const reversed = scene.pinned.slice().reverse();
      for (const simulation of [trusted, other]) {
        expectOk(simulation.set_parameters(parameters));
        expectOk(simulation.set_pins(reversed, scene.targets));
        expectOk(simulation.step());
      }
      expect(other.p()).toEqual(trusted.p());
    }),
    { seed: 3, numRuns: 60 },
  );
});

test('bad input is refused as by the trusted one, and leaves everything as it was', () => {
  const simulation = openMistaken(net(3), usualParameters, 'k-forgotten');
  expectOk(simulation.step());
  const p = simulation.p().slice();
  const scene = net(3);
  const refused = [
    simulation.set_scene(scene.V, Int32Array.of(0, 12), scene.m, scene.pinned, usualParameters, 'none'),
    simulation.set_parameters({ ...usualParameters, k: Number.NaN }),
    simulation.set_parameters({ ...usualParameters, k: 1e15 }),
    simulation.set_pins(Int32Array.of(0, 0), new Float64Array(6)),
    simulation.set_state(1, net(3).V, net(3).V.fill(Number.POSITIVE_INFINITY), 0),
    simulation.set_state(1, net(3).V, net(3).V, 1 as 0),
  ];
  expect(refused.map(({ code, field }) => `${field} ${code}`)).toEqual([
    'E index_out_of_range',
    'k not_finite',
    'stiffness_number too_stiff',
    'pinned duplicate_vertex',
    'p_prev not_finite',
    'half_step index_out_of_range',
  ]);
  expect([simulation.step_number(), simulation.half_step(), simulation.p()]).toEqual([1, 21, p]);
  const untouched = openMistaken(net(3), usualParameters, 'k-forgotten');
  for (let step = 0; step < 2; step++) expectOk(untouched.step());
  expectOk(simulation.step());
  expect(simulation.p()).toEqual(untouched.p());
});

test('calls before there is a scene', () => {
  const simulation = new solver.MistakenSimulation();
  const statuses = [simulation.step(), simulation.reset(), simulation.set_parameters(usualParameters)];
  expect(statuses.map(({ code }) => code)).toEqual(['no_scene', 'no_scene', 'no_scene']);
  expect(simulation.p()).toHaveLength(0);
  expect(simulation.stored_in_L()).toBe(0);
  simulation.delete();
});

test('zeros that would fill the memory are refused before they are stored', () => {
  const simulation = openMistaken(chain(3), usualParameters, 'none');
  const long = chain(1500);
  const { code, field } = simulation.set_scene(long.V, long.E, long.m, long.pinned, usualParameters, 'stored-zeros');
  expect([code, field]).toEqual(['too_large', 'zeros']);
  expect(simulation.vertex_count()).toBe(3);
});

test('a time step that diverges says where, hands out no number that is not finite, and can be left', () => {
  const simulation = openMistaken(net(4), usualParameters, 'times-swapped');
  let status = simulation.step();
  for (let step = 1; step < 100 && status.code === 'ok'; step++) status = simulation.step();
  expect(status).toMatchObject({ code: 'diverged', field: 'p', limit: 1e6 });
  expect(status.index).toBeGreaterThanOrEqual(0);
  expect(simulation.half_step() % 2).toBe(0); // a global step: the local one only turns and scales
  expect(simulation.half_step()).toBeGreaterThan(0);
  const failed = simulation.step_number();
  expect(simulation.p()).toEqual(simulation.p_curr());
  expect(simulation.p().every(Number.isFinite)).toBe(true);
  expect(simulation.step()).toEqual(status); // and stays there
  expectOk(simulation.set_pins(net(4).pinned, new Float64Array(6)));
  expect(simulation.step()).toEqual(status);
  expect(simulation.step_number()).toBe(failed);
  expectOk(simulation.reset());
  expectOk(simulation.step());
  expect(simulation.step_number()).toBe(1);
});
