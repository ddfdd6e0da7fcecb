import { expect, test } from 'vitest';
import type { Parameters } from '../../web/src/solver/module.ts';
import { expectOk, openSimulation, place } from '../support/open_simulation.ts';
import { net, usualParameters } from '../support/small_scenes.ts';

test('a scene is factorised once', () => {
  const simulation = openSimulation(net(3), usualParameters);
  expect(simulation.factorisation_count()).toBe(1);
  expect(simulation.factorisation_reason()).toBe('scene');
});

test.each<[string, Partial<Parameters>]>([
  ['k', { k: 500 }],
  ['delta_t', { delta_t: 0.01 }],
  ['mass', { mass_scale: 2 }],
  ['w', { w: 1e8 }],
  ['storage', { storage: 'dense' }],
])('a change of %s factorises anew, and says why', (reason, change) => {
  const simulation = openSimulation(net(3), usualParameters);
  expectOk(simulation.set_parameters({ ...usualParameters, ...change }));
  expect(simulation.factorisation_count()).toBe(2);
  expect(simulation.factorisation_reason()).toBe(reason);
  // The kept ordering serves the new values: all is as if the scene had been opened with them.
  expectOk(simulation.step());
  const fresh = openSimulation(net(3), { ...usualParameters, ...change });
  expectOk(fresh.step());
  expect(place(simulation)).toEqual(place(fresh));
});

test.each<[string, Partial<Parameters>]>([
  ['nothing', {}],
  ['gravity', { gravity: 1 }],
  ['wind', { wind: true }],
  ['the number of iterations', { iterations: 3 }],
])('a change of %s needs no factorisation', (_, change) => {
  const simulation = openSimulation(net(3), usualParameters);
  expectOk(simulation.set_parameters({ ...usualParameters, ...change }));
  expect(simulation.factorisation_count()).toBe(1);
});

test('dragging pins needs no factorisation, another set of pins does', () => {
  const simulation = openSimulation(net(3), usualParameters);
  for (let x = 0; x < 5; x++) {
    expectOk(simulation.set_pins(Int32Array.of(0, 2), Float64Array.of(x, 0, 0, 1, x, 0)));
    expectOk(simulation.step());
  }
  expectOk(simulation.set_pins(Int32Array.of(2, 0), new Float64Array(6))); // the same set
  expect(simulation.factorisation_count()).toBe(1);
  expectOk(simulation.set_pins(Int32Array.of(0), new Float64Array(3)));
  expectOk(simulation.set_pins(Int32Array.of(1), new Float64Array(3)));
  expectOk(simulation.set_pins(new Int32Array(), new Float64Array()));
  expect(simulation.factorisation_count()).toBe(4);
  expect(simulation.factorisation_reason()).toBe('pins');
});

test('stepping, seeking and resetting need no factorisation', () => {
  const simulation = openSimulation(net(3), usualParameters);
  expectOk(simulation.step());
  expectOk(simulation.seek(3));
  expectOk(simulation.next_step());
  simulation.previous_step();
  expectOk(simulation.reset());
  expect(simulation.factorisation_count()).toBe(1);
});

test('the stiffness number is the largest Σk Δt²/m', () => {
  const simulation = openSimulation(net(3), { ...usualParameters, mass_scale: 0.5 });
  // The vertex in the middle of the net has six springs.
  expect(simulation.stiffness_number()).toBeCloseTo((6 * 1e3) / 30 ** 2 / 0.5, 12);
});
