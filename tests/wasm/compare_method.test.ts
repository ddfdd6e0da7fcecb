import { describe, expect, it } from 'vitest';
import { compareMethod } from '../../web/src/solver/compare_method.ts';
import { measureIteration } from '../../web/src/solver/measure_iteration.ts';
import { minimisers } from '../../web/src/solver/module.ts';
import { openSimulation, place } from '../support/open_simulation.ts';
import { net, usualParameters } from '../support/small_scenes.ts';

/** J: 25 kg at most 1 m up make terms of 250 J, known to 250 · 2e-16 each. */
const rounding = 1e-12;

const falling = () => {
  const simulation = openSimulation(net(5), { ...usualParameters, path: 'fast' });
  simulation.step();
  simulation.next_step();
  return simulation;
};

describe('the real solver', () => {
  it('compares all minimisers on one time step, without moving', () => {
    const simulation = falling();
    const before = place(simulation);
    for (const method of minimisers) {
      const outcome = compareMethod(simulation, { method, iterations: 30, patience_ms: 1000 });
      if (!outcome.ok) throw new Error(outcome.status.code);
      const { change, milliseconds } = outcome.value;
      expect(change[0]).toBe(0);
      expect(change[change.length - 1]).toBeLessThan(0);
      for (let k = 1; k < change.length; k++) expect(change[k]).toBeLessThanOrEqual(change[k - 1] + rounding);
      expect(milliseconds).toBeGreaterThan(0);
    }
    expect(place(simulation)).toEqual(before);
  });

  it('rehearses both halves of an iteration, without moving', () => {
    const simulation = falling();
    const before = place(simulation);
    const { local, global } = measureIteration(simulation);
    expect(Math.min(local, global)).toBeGreaterThan(0);
    expect(place(simulation)).toEqual(before);
  });
});
