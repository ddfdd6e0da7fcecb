import { expect, test } from 'vitest';
import { springPulls } from '../../../../../web/src/labs/lesson/figures/spring_pulls.ts';
import { openSimulation } from '../../../../support/open_simulation.ts';
import { chain, net, usualParameters } from '../../../../support/small_scenes.ts';

test('a spring of rest length 1, stretched to 3, pulls both ends with 2k, towards each other', () => {
  const pulls = springPulls(chain(2), 5, Float64Array.of(1), Float64Array.of(0, 0, 0, 0, 3, 0));
  expect(pulls).toEqual([
    [0, 10],
    [0, -10],
  ]);
});

test('the pulls are minus the springs’ part of the solver’s gradient', () => {
  const scene = net(3);
  const simulation = openSimulation({ ...scene, pinned: new Int32Array(0) }, { ...usualParameters, gravity: 0 });
  const p = scene.V.map((coordinate, c) => (c % 3 === 2 ? 0 : coordinate + 0.02 * Math.sin(c)));
  // At p^t = p^{t-Δt} = p inertia asks for nothing.
  simulation.set_state(1, p, p, 0);
  const gradient = simulation.gradient_at(p);
  const pulls = springPulls(scene, usualParameters.k, simulation.r().slice(), p);
  for (const [i, pull] of pulls.entries()) {
    // Forces of up to 30 N, rounded in the 16th digit.
    for (const axis of [0, 1]) expect(pull[axis]).toBeCloseTo(-gradient[3 * i + axis], 10);
  }
});
