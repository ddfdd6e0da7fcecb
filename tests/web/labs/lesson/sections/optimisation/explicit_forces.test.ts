import { describe, expect, it } from 'vitest';
import { angularFrequency, exploded } from '../../../../../../web/src/labs/lesson/sections/optimisation/stability.ts';
import type { Simulation } from '../../../../../../web/src/solver/module.ts';
import { sceneParameters } from '../../../../../../web/src/solver/scene_parameters.ts';
import { energyOf } from '../../../../../support/energy_of.ts';
import { openScene } from '../../../../../support/open_scene.ts';
import { expectOk, openSimulation } from '../../../../../support/open_simulation.ts';

const spring = await openScene('single-spring-horizontal');
const k = 2000;
const omega = angularFrequency(k, spring.m[1]);

/** J: changes of the energy over so many time steps of Δt = product/ω, from rest. */
function changes(product: number, steps: number, next: (s: Simulation) => Float64Array): number[] {
  const delta_t = product / omega;
  const s = openSimulation(spring, { ...sceneParameters(spring), k, delta_t });
  let [now, before] = [spring.V, spring.V];
  const start = energyOf(s, delta_t, now, before);
  return Array.from({ length: steps }, (_, step) => {
    expectOk(s.set_state(step + 1, now, before, 0));
    [now, before] = [next(s).slice(), now];
    return energyOf(s, delta_t, now, before) - start;
  });
}

const explicit = (s: Simulation) => s.explicit_step();
const implicit = (s: Simulation) => {
  expectOk(s.step());
  return s.p();
};

describe('one spring, and Δt ω', () => {
  it('just above 2: forces at the start of the step blow it up', () => {
    expect(Math.max(...changes(2.1, 100, explicit))).toBeGreaterThan(exploded);
  });

  it('below 2: the energy sways but stays, and is nearer to what it was than with implicit steps', () => {
    const swaying = changes(1.8, 500, explicit);
    expect(Math.max(...swaying.map(Math.abs))).toBeLessThan(1); // J, of about 10 J that the mass can fall
    expect(changes(1.8, 500, implicit).at(-1)).toBeLessThan(-5);
  });

  it.each([1, 2.1, 10])('%f: forces at the end of the step add no energy', (product) => {
    expect(Math.max(...changes(product, 100, implicit))).toBeLessThan(1e-9); // J: rounding
  });
});
