import { expect, test } from 'vitest';
import {
  type Elimination,
  methods,
  orderings,
  type Simulation,
  type SolvingExample,
  statusCodes,
  traceColumns,
} from '../../web/src/solver/module.ts';
import { openScene } from '../support/open_scene.ts';
import { distance, expectOk, openSimulation, solver, anyStatus as status } from '../support/open_simulation.ts';
import { positionsTolerance } from '../support/positions_tolerance.ts';
import { chain, net, usualParameters } from '../support/small_scenes.ts';

const { V, E, m, pinned } = chain(3);
const triplets = {
  rows: expect.any(Number),
  columns: expect.any(Number),
  i: expect.any(Int32Array),
  j: expect.any(Int32Array),
  value: expect.any(Float64Array),
};
const vector = [expect.any(Number), expect.any(Number), expect.any(Number)];
const number = expect.any(Number);
const doubles = expect.any(Float64Array);
const indices = expect.any(Int32Array);

/** Every call of the hand-written interface, by the compiler's word, with what the real module returns. */
const calls: { [Name in keyof Simulation]: [arguments: Parameters<Simulation[Name]>, result: unknown] } = {
  set_progress: [[() => {}], undefined],
  set_scene: [[V, E, m, pinned, usualParameters], status],
  set_parameters: [[usualParameters], status],
  set_pins: [[pinned, new Float64Array(3)], status],
  set_pull: [[Int32Array.of(2), new Float64Array(3), 10], status],
  reset: [[], status],
  set_state: [[1, V, V, 0], status],
  step: [[], status],
  seek: [[2], status],
  next_step: [[], status],
  previous_step: [[], expect.any(Boolean)],
  back_to: [[1], expect.any(Boolean)],
  remembered_steps: [[], number],
  step_number: [[], number],
  half_step: [[], number],
  last_half_step: [[], number],
  stop_reason: [[], 'iterations'],
  rehearse_local_step: [[2], undefined],
  rehearse_global_step: [[2], undefined],
  compare: [['lbfgs', 3], { status, rows: doubles }],
  vertex_count: [[], 3],
  spring_count: [[], 2],
  p: [[], doubles],
  p_before: [[], doubles],
  p_curr: [[], doubles],
  p_prev: [[], doubles],
  inertial_prediction: [[], doubles],
  explicit_step: [[], doubles],
  d: [[], doubles],
  r: [[], Float64Array.of(0.5, 0.5)],
  m: [[], Float64Array.of(1, 1, 1)],
  targets: [[], Float64Array.of(0, 0, 0)],
  trace: [[], doubles],
  probe_vertex: [[1], { y: vector, kAtd: vector, b: vector, Qp: vector, springs: indices, shares: doubles }],
  energy: [[], { kinetic: number, springs: number, external: number }],
  velocity: [[], doubles],
  largest_frequency: [[], number],
  stability_limit: [[], Number.POSITIVE_INFINITY],
  stiffness_number: [[], number],
  factorisation_count: [[], number],
  factorisation_reason: [[], 'pull'],
  A: [[], triplets],
  M: [[], triplets],
  C: [[], triplets],
  Q: [[], triplets],
  system_matrix_terms: [[], { AtA: triplets, springs: triplets, masses: triplets, pins: triplets }],
  linearly_implicit_terms: [[], { K: triplets, D: triplets, P: triplets, system: triplets, constrained: triplets }],
  settled: [[], doubles],
  spring_stiffness: [[1], doubles],
  spring_resistance: [[1], doubles],
  order: [['solver'], indices],
  elimination: [['natural'], expect.any(solver.Elimination)],
  solving_example: [[], expect.any(solver.SolvingExample)],
  y: [[], doubles],
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
  gradient_at: [[V], doubles],
  delete: [[], undefined],
};

const eliminationCalls: { [Name in keyof Elimination]: [arguments: Parameters<Elimination[Name]>, result: unknown] } = {
  order: [[], Int32Array.of(0, 1, 2)],
  parent: [[], Int32Array.of(1, 2, -1)],
  height: [[], Int32Array.of(1, 1, 0)],
  nonzeros: [[], 5],
  nonzeros_of_Q: [[], 5],
  fill: [[], 0],
  flops: [[], 9],
  most_flops: [[], number],
  factorise: [[], true],
  after: [[1], { ...triplets, born: indices, status }],
  delete: [[], undefined],
};

const exampleCalls: {
  [Name in keyof SolvingExample]: [arguments: Parameters<SolvingExample[Name]>, result: unknown];
} = {
  vertex_count: [[], 3],
  dense_inverse: [[], true],
  dense_factorise: [[], true],
  dense_substitute: [[], true],
  sparse_factorise: [[], undefined],
  sparse_substitute: [[], undefined],
  dense_bytes: [[], 72],
  sparse_matrix_bytes: [[], 7 * 12],
  sparse_factor_bytes: [[], 5 * 12],
  residual: [[], number],
  delete: [[], undefined],
};

test.each([
  ['Simulation', () => new solver.Simulation(), calls],
  ['Elimination', () => openSimulation(chain(3), usualParameters).elimination('natural'), eliminationCalls],
  ['SolvingExample', () => openSimulation(chain(3), usualParameters).solving_example(), exampleCalls],
] as const)('%s has exactly the calls of its interface, and they return what it says', (name, open, calls) => {
  const object = open() as unknown as Record<string, (...inputs: unknown[]) => unknown>;
  const { delete: _, ...registered } = calls; // embind gives every class its delete
  expect(Object.keys(solver[name].prototype).sort()).toEqual(Object.keys(registered).sort());
  for (const [name, [inputs, result]] of Object.entries(calls)) {
    expect(object[name](...inputs), name).toEqual(result);
  }
});

test('the names of the status codes, of the methods and of the orderings', () => {
  expect(solver.status_codes()).toEqual([...statusCodes]);
  expect(solver.methods()).toEqual([...methods]);
  expect(solver.orderings()).toEqual([...orderings]);
});

test('the columns of the trace', () => {
  expect(openSimulation(chain(3), usualParameters).trace()).toHaveLength(traceColumns.length);
});

test('each entry of a matrix occurs once', () => {
  const { i, j, rows } = openSimulation(net(3), usualParameters).Q();
  expect(new Set(i.map((row, t) => row * rows + j[t])).size).toBe(i.length);
});

test('two simulations do not know of each other', () => {
  const [one, other] = [chain(3), net(3)].map((scene) => openSimulation(scene, usualParameters));
  expectOk(one.step());
  expect([one.step_number(), one.half_step()]).toEqual([1, 21]);
  expect([other.step_number(), other.half_step()]).toEqual([1, 0]);
  expect(other.p()).toEqual(net(3).V);
});

test('a dense flag fits into the memory and moves like a sparse one; views that it moved are empty', async () => {
  const flag = await openScene('flag');
  const parameters = { ...usualParameters, iterations: 1 };
  const small = openSimulation(chain(3), parameters);
  const view = small.p();
  const simulation = openSimulation(flag, { ...parameters, storage: 'dense' });
  expect(view).toHaveLength(0);
  expect(small.p()).toEqual(chain(3).V);
  expectOk(simulation.seek(3));
  // Another scene, another storage and back again: the memory is given back each time.
  expectOk(simulation.set_parameters(parameters));
  expectOk(simulation.set_scene(flag.V, flag.E, flag.m, flag.pinned, { ...parameters, storage: 'dense' }));
  expectOk(simulation.set_scene(V, E, m, pinned, { ...parameters, storage: 'dense' }));
  expectOk(simulation.set_scene(flag.V, flag.E, flag.m, flag.pinned, { ...parameters, storage: 'dense' }));
  // Three time steps of it, on which sparse storage agrees.
  const sparse = openSimulation(flag, parameters);
  for (let step = 0; step < 3; step++) {
    expectOk(simulation.step());
    expectOk(sparse.step());
  }
  const p = simulation.p().slice();
  expect(distance(p, flag.V)).toBeGreaterThan(1e3 * positionsTolerance(flag)); // it moved
  expect(distance(p, sparse.p())).toBeLessThan(positionsTolerance(flag));
}, 60_000);

test('every way to solve the example leaves no residual', () => {
  const example = new solver.SolvingExample(12);
  expect(example.vertex_count()).toBe(144);
  expect(example.dense_inverse()).toBe(true);
  for (const storage of ['dense', 'sparse'] as const) {
    example[`${storage}_factorise`]();
    example[`${storage}_substitute`]();
    // Forces of 9.8 N are passed on to the pins, w |p| of 1e3 N: rounded in the 16th digit, times a few.
    expect(example.residual()).toBeLessThan(1e-11);
  }
  example.delete();
});

test('the example refuses dense matrices that are too large', () => {
  const example = new solver.SolvingExample(46);
  for (const call of ['dense_inverse', 'dense_factorise', 'dense_substitute'] as const)
    expect(example[call]()).toBe(false);
  example.delete();
});
