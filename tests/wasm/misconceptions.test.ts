/** Each mistake shows the symptom that the cabinet of misconceptions claims, in the scene that it offers. */
import { expect, test } from 'vitest';
import type { Mistake, MistakenSimulation } from '../../web/src/solver/mistaken_simulation.ts';
import { sceneParameters } from '../../web/src/solver/scene_parameters.ts';
import { openMistaken } from '../support/open_mistaken.ts';
import { openScene } from '../support/open_scene.ts';
import { expectOk } from '../support/open_simulation.ts';

const pendulum = await openScene('single-spring-horizontal');
const net = await openScene('net');
const tower = await openScene('tower');

const open = (scene: typeof net, mistake: Mistake, changed = {}) =>
  openMistaken(scene, { ...sceneParameters(scene), ...changed }, mistake);

function run(simulation: MistakenSimulation, steps: number): void {
  for (let step = 0; step < steps; step++) expectOk(simulation.step());
}

/** y of the lowest vertex, m. */
const low = (simulation: MistakenSimulation) =>
  simulation.p().reduce((y, height, c) => (c % 3 === 1 ? Math.min(y, height) : y), 0);

/** The same after every time step. */
function lowest(scene: typeof net, mistake: Mistake, steps: number, changed = {}): number[] {
  const simulation = open(scene, mistake, changed);
  return Array.from({ length: steps }, () => {
    run(simulation, 1);
    return low(simulation);
  });
}

/** Kinetic, of the springs and of gravity, J. */
function energy(simulation: MistakenSimulation): number {
  const { kinetic, springs, external } = simulation.energy();
  return kinetic + springs + external;
}

function lengths(scene: typeof net, p: Float64Array): number[] {
  return Array.from({ length: scene.E.length / 2 }, (_, e) => {
    const [i, j] = [3 * scene.E[2 * e], 3 * scene.E[2 * e + 1]];
    return Math.hypot(p[i] - p[j], p[i + 1] - p[j + 1], p[i + 2] - p[j + 2]);
  });
}

const mean = (values: readonly number[]) => values.reduce((a, b) => a + b, 0) / values.length;

test('d never refreshed: fifty iterations make the positions of one, bit for bit', () => {
  const [stale, once] = [open(net, 'd-once'), open(net, 'one-iteration')];
  run(stale, 60);
  run(once, 60);
  expect(stale.p()).toEqual(once.p());
});

test('one iteration, or d never refreshed: the pendulum creeps to rest instead of swinging', () => {
  const right = lowest(pendulum, 'none', 80);
  const wrong = lowest(pendulum, 'one-iteration', 80);
  // Hanging at rest, its spring is 1 m + mg/k = 1.098 m long. Fifty iterations pass the lowest point and come up again by 0.72 m.
  expect(Math.max(...right.slice(20)) - Math.min(...right)).toBeGreaterThan(0.7);
  // One goes down there without coming up again by more than 3 cm.
  expect(wrong[79]).toBeCloseTo(-1.098, 2);
  expect(Math.max(...wrong.slice(30)) - Math.min(...wrong)).toBeLessThan(0.03);
  // Energy lost to the numbers in the first second: 4.4 J of the 9.8 J that were there to swing with, and 9.4 J.
  const [fifty, one] = [open(pendulum, 'none'), open(pendulum, 'one-iteration')];
  run(fifty, 30);
  run(one, 30);
  expect(energy(fifty)).toBeGreaterThan(-4.5);
  expect(energy(one)).toBeLessThan(-9.4);
});

test('k forgotten in b: every spring shrinks as if it rested at r/k', () => {
  const simulation = open(pendulum, 'k-forgotten');
  run(simulation, 400);
  // The pull of k(l − r/k) carries mg: l = 0.01 m + 0.098 m.
  expect(lengths(pendulum, simulation.p())[0]).toBeCloseTo(0.108, 4);
  // The net is drawn flat between its pins: 0.19 m below them, where the right one hangs 0.88 m.
  const [right, wrong] = [open(net, 'none'), open(net, 'k-forgotten')];
  run(right, 400);
  run(wrong, 400);
  expect(low(right)).toBeCloseTo(-0.88, 1);
  expect(low(wrong)).toBeCloseTo(-0.19, 1);
});

test('wrong sign in A: energy appears from nowhere at once and the net stays in knots', () => {
  const simulation = open(net, 'sign-in-A');
  run(simulation, 3);
  expect(energy(simulation)).toBeGreaterThan(8000);
  expect(Math.max(...lengths(net, simulation.p())) / Math.max(...lengths(net, net.V))).toBeGreaterThan(3);
  run(simulation, 77);
  expect(energy(simulation)).toBeGreaterThan(5000);
  // The right one only loses.
  const right = open(net, 'none');
  run(right, 80);
  expect(energy(right)).toBeLessThan(-100);
});

test('p^t and p^{t-Δt} swapped: turned round and doubled every time step, until it is out of reach', () => {
  const simulation = open(net, 'times-swapped');
  // Alone, λ² + λ − 2 = 0: what moves is reversed and doubled, λ = −2.
  const heights: number[] = [];
  for (let step = 0; step < 10; step++) {
    run(simulation, 1);
    heights.push(simulation.p()[1]);
  }
  const moves = heights.slice(1).map((y, n) => y - heights[n]);
  for (let n = 1; n < 6; n++) expect(moves[n] / moves[n - 1]).toBeLessThan(-1.5);
  let status = simulation.step();
  while (status.code === 'ok') status = simulation.step();
  expect(status.code).toBe('diverged');
  expect([simulation.step_number(), simulation.half_step()]).toEqual([30, 2]);
  // Springs that are stiff for the time step hide it.
  const hidden = open(tower, 'times-swapped');
  run(hidden, 60);
  expect(Math.max(...hidden.p().map((x, c) => Math.abs(x - tower.V[c])))).toBeLessThan(0.01);
});

test('CᵀC V where Cᵀp^target belongs: nothing is wrong until a pin is moved, and then it stays', () => {
  const [right, wrong] = [open(net, 'none'), open(net, 'rest-for-targets')];
  run(right, 20);
  run(wrong, 20);
  // Rounding: the pin's terms are added up in another order; 10¹⁰ N/m of w over 10² of the rest costs 8 of 16 digits.
  expect(Math.max(...wrong.p().map((x, c) => Math.abs(x - right.p()[c])))).toBeLessThan(1e-7);
  const moved = Float64Array.from({ length: 3 * net.pinned.length }, (_, c) => {
    return net.V[3 * net.pinned[Math.floor(c / 3)] + (c % 3)] + (c % 3 === 0 ? 0.5 : 0);
  });
  for (const simulation of [right, wrong]) {
    expectOk(simulation.set_pins(net.pinned, moved));
    run(simulation, 20);
  }
  const pin = 3 * net.pinned[0];
  expect(right.p()[pin] - net.V[pin]).toBeCloseTo(0.5, 6);
  expect(wrong.p()[pin] - net.V[pin]).toBeCloseTo(0, 6);
});

test('pins imposed after solving: the springs at the pins give way', () => {
  const deepest = (mistake: Mistake) => Math.min(...lowest(net, mistake, 80));
  // 1.30 m becomes 1.75 m.
  expect(deepest('pins-after-solving') / deepest('none')).toBeGreaterThan(1.2);
  // At rest the springs at the pins are stretched by 76 % instead of 29 %, though the pins themselves stand where they should.
  const atPins = (mistake: Mistake) => {
    const simulation = open(net, mistake);
    run(simulation, 400);
    const pin = 3 * net.pinned[0];
    expect(Math.abs(simulation.p()[pin] - net.V[pin])).toBeLessThan(1e-6);
    const rest = lengths(net, net.V);
    const pinned = new Set(net.pinned);
    const stretches = lengths(net, simulation.p()).map((length, e) => length / rest[e]);
    return mean(stretches.filter((_, e) => pinned.has(net.E[2 * e]) || pinned.has(net.E[2 * e + 1])));
  };
  expect(atPins('none')).toBeCloseTo(1.29, 1);
  expect(atPins('pins-after-solving')).toBeCloseTo(1.76, 1);
});

test('factorised in every iteration: K factorisations a time step for the same bits', () => {
  const [right, wrong] = [open(net, 'none'), open(net, 'factorised-again')];
  run(right, 4);
  run(wrong, 4);
  expect(right.factorisation_count()).toBe(1);
  expect(wrong.factorisation_count()).toBe(1 + 4 * 50);
  expect(wrong.p()).toEqual(right.p());
});

test('gradient as force: the net falls upwards, as far as the right one falls down', () => {
  const [right, wrong] = [open(net, 'none'), open(net, 'gradient-as-force')];
  run(right, 30);
  run(wrong, 30);
  const y = (simulation: MistakenSimulation) => simulation.p().filter((_, c) => c % 3 === 1);
  const [down, up] = [y(right), y(wrong)];
  expect(Math.min(...down)).toBeLessThan(-0.6);
  // The net lies in a plane y = 0: mirror images, to the rounding of 30 solves with w = 10¹⁰ N/m.
  expect(Math.max(...down.map((height, i) => Math.abs(height + up[i])))).toBeLessThan(1e-6);
});

test('stored zeros: n² entries instead of those of the springs, for the same positions', () => {
  const n = tower.m.length;
  const [right, wrong] = [open(tower, 'none'), open(tower, 'stored-zeros')];
  expect([right.stored_in_Q(), right.nonzeros_of_Q()]).toEqual([1745, 1745]);
  expect([wrong.stored_in_Q(), wrong.nonzeros_of_Q()]).toEqual([n * n, 1745]);
  // L fills up to its whole triangle.
  expect(wrong.stored_in_L()).toBe((n * (n + 1)) / 2);
  expect(right.stored_in_L()).toBeLessThan(4000);
  run(right, 3);
  run(wrong, 3);
  // Another order of elimination rounds otherwise; κ of the tower and w leave 7 digits.
  expect(Math.max(...wrong.p().map((x, c) => Math.abs(x - right.p()[c])))).toBeLessThan(1e-6);
});
