import fc from 'fast-check';
import { expect, test } from 'vitest';
import { catenary } from '../support/catenary.ts';
import { distance, expectOk, openMoving, openSimulation } from '../support/open_simulation.ts';
import { chain, movingScenes, net, usualParameters } from '../support/small_scenes.ts';

test('one iteration of a single spring, by hand', () => {
  // Two unit masses at x = 0 and 2, at rest; rest length 1, k = 1 N/m, Δt = 1 s, no gravity.
  const spring = { ...chain(2, 1), pinned: new Int32Array() };
  const simulation = openSimulation(spring, { ...usualParameters, k: 1, delta_t: 1, iterations: 1, gravity: 0 });
  const stretched = Float64Array.of(0, 0, 0, 2, 0, 0);
  expectOk(simulation.set_state(1, stretched, stretched, 0));
  // local: d = (−1, 0, 0), from the second vertex to the first
  expectOk(simulation.seek(1));
  expect([...simulation.d()]).toEqual([-1, 0, 0]);
  // global: Q = [[2 −1] [−1 2]], b = Aᵀd + p^t = (−1, 1 + 2), Q⁻¹b = (1/3, 5/3)
  expectOk(simulation.seek(2));
  expect(distance(simulation.p(), [1 / 3, 0, 0, 5 / 3, 0, 0])).toBeLessThan(1e-15);
});

test('the centre of mass falls freely, whatever the springs and however few the iterations', () => {
  fc.assert(
    fc.property(movingScenes, fc.integer({ min: 1, max: 50 }), (scene, iterations) => {
      const none = { pinned: new Int32Array(), targets: new Float64Array() };
      const parameters = { ...scene.parameters, iterations, k: 100, delta_t: 1 / 30, wind: false };
      const simulation = openMoving({ ...scene, ...none, parameters });
      expectOk(simulation.step());
      const p = simulation.p();
      const mass = scene.m.reduce((a, b) => a + b, 0);
      const centre = (points: Float64Array, axis: number) =>
        scene.m.reduce((sum, m, i) => sum + m * points[3 * i + axis], 0) / mass;
      [0, -9.8, 0].forEach((g, axis) => {
        const fallen = 2 * centre(scene.p_curr, axis) - centre(scene.p_prev, axis) + g / 30 ** 2;
        // κ is at most 10, of 16 digits.
        expect(Math.abs(centre(p, axis) - fallen)).toBeLessThan(1e-13);
      });
    }),
    { seed: 5, numRuns: 100 },
  );
});

test('pin drift is the reaction divided by w', () => {
  // Held at the origin, where the drift of about 1e-8 m is not rounded to the digits of a coordinate.
  const scene = chain(5);
  const parameters = { ...usualParameters, w: 1e9, wind: true };
  const simulation = openSimulation(scene, parameters);
  for (let step = 0; step < 10; step++) expectOk(simulation.step());
  const [p, free] = [simulation.p().slice(), simulation.inertial_prediction().slice()];
  for (let axis = 0; axis < 3; axis++) {
    // All the force that keeps the chain from moving freely comes through the pin: springs only pass it on.
    let reaction = 0; // N
    scene.m.forEach((m, i) => {
      reaction += (m * (p[3 * i + axis] - free[3 * i + axis])) / parameters.delta_t ** 2;
    });
    expect(Math.abs(reaction)).toBeGreaterThan(1);
    // The reaction is a difference of positions, known to 1e-16 m times m/Δt² = 900 N/m.
    expect(Math.abs(-parameters.w * p[axis] - reaction)).toBeLessThan(1e-10);
  }
});

test('a hanging chain comes to rest in the discrete elastic catenary', () => {
  const n = 12;
  const scene = { ...chain(n, 0.1), m: new Float64Array(n).fill(0.1), pinned: Int32Array.of(0, n - 1) };
  // Long time steps damp the motion away within some tens of them.
  const parameters = { ...usualParameters, k: 100, delta_t: 0.5, iterations: 20 };
  const simulation = openSimulation(scene, parameters);
  for (let step = 0; step < 300; step++) expectOk(simulation.step());
  const expected = catenary({ n, spacing: 0.1, mass: 0.1, k: 100, gravity: 9.8 });
  // What is left is how the pins give way: some newtons over w = 1e10 N/m.
  expect(distance(simulation.p(), expected)).toBeLessThan(1e-9);
  expect(simulation.p()[3 * (n / 2) + 1]).toBeLessThan(-0.1); // and it does hang
});

test('dense and sparse storage make the same motion', () => {
  const [sparse, dense] = (['sparse', 'dense'] as const).map((storage) => {
    const simulation = openSimulation(net(5), { ...usualParameters, storage, wind: true });
    for (let step = 0; step < 30; step++) expectOk(simulation.step());
    return simulation.p().slice();
  });
  // They add the same numbers in another order, 300 iterations long.
  expect(distance(sparse, dense)).toBeLessThan(1e-10);
});

test('a vertex without springs falls beside the others', () => {
  const scene = { ...chain(3), E: Int32Array.of(0, 1) };
  const simulation = openSimulation(scene, usualParameters);
  expectOk(simulation.step());
  expect(distance(simulation.p().subarray(6), [1, -9.8 / 30 ** 2, 0])).toBeLessThan(1e-15);
});

test('wind repeats: it depends on the simulated time alone', () => {
  const blown = () => {
    const simulation = openSimulation(net(3), { ...usualParameters, wind: true });
    for (let step = 0; step < 5; step++) expectOk(simulation.step());
    return simulation.p().slice();
  };
  expect(blown()).toEqual(blown());
  expect(blown().some((coordinate, c) => c % 3 === 2 && coordinate !== 0)).toBe(true);
});

test('energy is that of the settled positions: what a time step ends with, the next one begins with', () => {
  const simulation = openSimulation(net(4), usualParameters);
  for (let step = 0; step < 5; step++) expectOk(simulation.step());
  const ended = simulation.energy();
  expect(ended.kinetic).toBeGreaterThan(0);
  const { potential, external } = simulation.objective_at(simulation.p().slice());
  // The same terms, summed one by one: some 50 roundings of numbers below 50 J.
  expect(ended.springs).toBeCloseTo(potential, 12);
  expect(ended.external).toBeCloseTo(external, 12);
  expectOk(simulation.next_step());
  expect(simulation.energy()).toEqual(ended);
  expectOk(simulation.seek(5)); // inside a time step nothing is settled yet
  expect(simulation.energy()).toEqual(ended);
});
