import { expect, test } from 'vitest';
import type { Parameters, Simulation, Status } from '../../web/src/solver/module.ts';
import { expectOk, openSimulation, place, solver } from '../support/open_simulation.ts';
import { chain, net, type SmallScene, usualParameters } from '../support/small_scenes.ts';

/** All that a failed call must leave as it was. */
const everything = (simulation: Simulation) => ({
  ...place(simulation),
  trace: simulation.trace().slice(),
  targets: simulation.targets().slice(),
  y: simulation.y().slice(),
  Q: simulation.Q(),
  count: simulation.factorisation_count(),
  reason: simulation.factorisation_reason(),
  remembered: simulation.remembered_steps(),
});

/** A status as the tables below write it: few have a limit. */
type Refusal = Omit<Status, 'limit'> & Partial<Status>;

/** Has the call refused in the middle of a traced time step. */
function expectRefusal(call: (simulation: Simulation) => Status, status: Refusal): void {
  const simulation = openSimulation(net(3), usualParameters);
  expectOk(simulation.step());
  expectOk(simulation.next_step());
  expectOk(simulation.seek(5));
  const before = everything(simulation);
  expect(call(simulation)).toEqual({ limit: 0, ...status });
  expect(everything(simulation)).toEqual(before);
}

const sceneErrors: [Partial<SmallScene>, Refusal][] = [
  [{ V: new Float64Array() }, { code: 'no_vertices', field: 'V', index: -1, value: 0 }],
  [{ V: new Float64Array(10) }, { code: 'wrong_length', field: 'V', index: -1, value: 10 }],
  [{ V: new Float64Array(9).fill(Number.NaN, 4) }, { code: 'not_finite', field: 'V', index: 1, value: Number.NaN }],
  [{ E: Int32Array.of(0, 1, 2) }, { code: 'wrong_length', field: 'E', index: -1, value: 3 }],
  [{ E: Int32Array.of(0, 1, 1, 3) }, { code: 'index_out_of_range', field: 'E', index: 1, value: 3 }],
  [{ E: Int32Array.of(-1, 1) }, { code: 'index_out_of_range', field: 'E', index: 0, value: -1 }],
  [{ E: Int32Array.of(1, 1) }, { code: 'self_spring', field: 'E', index: 0, value: 1 }],
  [{ E: Int32Array.of(0, 1, 1, 0) }, { code: 'duplicate_spring', field: 'E', index: 1, value: 0 }],
  [{ m: new Float64Array(2) }, { code: 'wrong_length', field: 'm', index: -1, value: 2 }],
  [{ m: Float64Array.of(1, 0, 1) }, { code: 'not_positive', field: 'm', index: 1, value: 0 }],
  [
    { m: Float64Array.of(1, 1, Number.POSITIVE_INFINITY) },
    { code: 'not_finite', field: 'm', index: 2, value: Number.POSITIVE_INFINITY },
  ],
  [{ pinned: Int32Array.of(3) }, { code: 'index_out_of_range', field: 'pinned', index: 0, value: 3 }],
  [{ pinned: Int32Array.of(1, 1) }, { code: 'duplicate_vertex', field: 'pinned', index: 1, value: 0 }],
];
test.each(sceneErrors)('scene with %j', (change, status) => {
  const { V, E, m, pinned } = { ...chain(3), ...change };
  expectRefusal((simulation) => simulation.set_scene(V, E, m, pinned, usualParameters), status);
});

const parameterErrors: [Partial<Parameters>, Refusal][] = [
  [{ k: 0 }, { code: 'not_positive', field: 'k', index: -1, value: 0 }],
  [{ k: Number.POSITIVE_INFINITY }, { code: 'not_finite', field: 'k', index: -1, value: Number.POSITIVE_INFINITY }],
  [{ delta_t: -1 }, { code: 'not_positive', field: 'delta_t', index: -1, value: -1 }],
  [{ w: 0 }, { code: 'not_positive', field: 'w', index: -1, value: 0 }],
  [{ mass_scale: 0 }, { code: 'not_positive', field: 'mass_scale', index: -1, value: 0 }],
  [{ iterations: 0 }, { code: 'not_positive', field: 'iterations', index: -1, value: 0 }],
  [{ iterations: 1e6 }, { code: 'too_large', field: 'iterations', index: -1, value: 160e6, limit: 16e6 }],
  [{ gravity: Number.NaN }, { code: 'not_finite', field: 'gravity', index: -1, value: Number.NaN }],
  // Vertex 4, in the middle of the net, has six springs of k and 1 kg.
  [
    { k: 1e9, delta_t: 1 },
    { code: 'too_stiff', field: 'stiffness_number', index: 4, value: 6e9, limit: 1e9 },
  ],
];
test.each(parameterErrors)('parameters with %j', (change, status) => {
  const parameters = { ...usualParameters, ...change };
  const { V, E, m, pinned } = net(3);
  expectRefusal((simulation) => simulation.set_parameters(parameters), status);
  expectRefusal((simulation) => simulation.set_scene(V, E, m, pinned, parameters), status);
});

const otherErrors: [string, (simulation: Simulation) => Status, Refusal][] = [
  [
    'a pin beyond the vertices',
    (simulation) => simulation.set_pins(Int32Array.of(0, 9), new Float64Array(6)),
    { code: 'index_out_of_range', field: 'pinned', index: 1, value: 9 },
  ],
  [
    'a pin twice',
    (simulation) => simulation.set_pins(Int32Array.of(4, 4), new Float64Array(6)),
    { code: 'duplicate_vertex', field: 'pinned', index: 1, value: 0 },
  ],
  [
    'fewer targets than pins',
    (simulation) => simulation.set_pins(Int32Array.of(0, 1), new Float64Array(3)),
    { code: 'wrong_length', field: 'targets', index: -1, value: 3 },
  ],
  [
    'a target nowhere',
    (simulation) => simulation.set_pins(Int32Array.of(0), Float64Array.of(0, Number.NaN, 0)),
    { code: 'not_finite', field: 'targets', index: 0, value: Number.NaN },
  ],
  [
    'a target so far that the step overflows',
    (simulation) => simulation.set_pins(Int32Array.of(0, 2), new Float64Array(6).fill(1e300)),
    { code: 'diverged', field: 'p', index: 0, value: Number.POSITIVE_INFINITY },
  ],
  [
    'a gravity so strong that the step overflows, with another stiffness',
    (simulation) => simulation.set_parameters({ ...usualParameters, k: 2000, gravity: 1e308 }),
    { code: 'diverged', field: 'p', index: 0, value: Number.NEGATIVE_INFINITY },
  ],
  [
    'a checkpoint of another scene',
    (simulation) => simulation.set_state(1, new Float64Array(3), new Float64Array(27), 0),
    { code: 'wrong_length', field: 'p_curr', index: -1, value: 3 },
  ],
  [
    'a checkpoint that is not finite',
    (simulation) =>
      simulation.set_state(1, new Float64Array(27), new Float64Array(27).fill(Number.POSITIVE_INFINITY, 26), 0),
    { code: 'not_finite', field: 'p_prev', index: 8, value: Number.POSITIVE_INFINITY },
  ],
  [
    'a checkpoint before the first time step',
    (simulation) => simulation.set_state(0, new Float64Array(27), new Float64Array(27), 0),
    { code: 'not_positive', field: 'step', index: -1, value: 0 },
  ],
  [
    'a checkpoint at a half-step that is not there',
    (simulation) => simulation.set_state(1, new Float64Array(27), new Float64Array(27), 99),
    { code: 'index_out_of_range', field: 'half_step', index: -1, value: 99 },
  ],
  [
    'a half-step before predict',
    (simulation) => simulation.seek(-1),
    { code: 'index_out_of_range', field: 'half_step', index: -1, value: -1 },
  ],
  [
    'a half-step after accept',
    (simulation) => simulation.seek(22),
    { code: 'index_out_of_range', field: 'half_step', index: -1, value: 22 },
  ],
];
test.each(otherErrors)('%s', (_, call, status) => {
  expectRefusal(call, status);
});

test('a dense scene beyond the memory, with its bytes', () => {
  const n = 6000;
  expectRefusal(
    (simulation) =>
      simulation.set_scene(new Float64Array(3 * n), new Int32Array(), new Float64Array(n).fill(1), new Int32Array(), {
        ...usualParameters,
        storage: 'dense',
      }),
    { code: 'too_large', field: 'storage', index: -1, value: 8 * 2 * n * n, limit: 450e6 },
  );
});

test('every call before there is a scene', () => {
  const simulation = new solver.Simulation();
  const none = { code: 'no_scene', field: '', index: -1, value: 0, limit: 0 };
  expect(simulation.set_parameters(usualParameters)).toEqual(none);
  expect(simulation.set_pins(new Int32Array(), new Float64Array())).toEqual(none);
  expect(simulation.reset()).toEqual(none);
  expect(simulation.set_state(1, new Float64Array(), new Float64Array(), 0)).toEqual(none);
  expect(simulation.step()).toEqual(none);
  expect(simulation.seek(0)).toEqual(none);
  expect(simulation.next_step()).toEqual(none);
  expect(simulation.previous_step()).toBe(false);
  expect(simulation.p()).toHaveLength(0);
  simulation.delete();
});
