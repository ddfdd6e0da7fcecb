import { describe, expect, test } from 'vitest';
import { compareMethod } from '../../web/src/solver/compare_method.ts';
import { minimisers } from '../../web/src/solver/module.ts';
import { stopOf } from '../../web/src/solver/stop_of.ts';
import { expectOk, openSimulation } from '../support/open_simulation.ts';
import { net, usualParameters } from '../support/small_scenes.ts';

const rules = [
  { iterations: 7, stop_gradient: 0, stop_decrease: 0 },
  { iterations: 200, stop_gradient: 1, stop_decrease: 0 },
  { iterations: 200, stop_gradient: 0, stop_decrease: 1e-3 },
  { iterations: 200, stop_gradient: 0, stop_decrease: 1e-7 },
  { iterations: 4, stop_gradient: 1e-6, stop_decrease: 0 },
  { iterations: 200, stop_gradient: 1e-15, stop_decrease: 0 }, // Newton's and others end where only rounding is left
];

describe.each(['fast', 'plain'] as const)('on the %s path', (path) => {
  test.each(minimisers.flatMap((method) => rules.map((rule) => ({ method, ...rule }))))(
    'the solver ends where the page marks it: $method, K = $iterations, ε = $stop_gradient N, $stop_decrease',
    ({ method, ...rule }) => {
      const simulation = openSimulation(net(6), { ...usualParameters, path, k: 1e5 });
      for (let step = 0; step < 3; step++) expectOk(simulation.step());
      expectOk(simulation.next_step());
      const outcome = compareMethod(simulation, { method, iterations: 200, patience_ms: Number.POSITIVE_INFINITY });
      if (!outcome.ok) throw new Error(outcome.status.code);

      expectOk(simulation.set_parameters({ ...usualParameters, path, k: 1e5, method, ...rule }));
      expectOk(simulation.step());
      expect(stopOf(outcome.value, rule)).toEqual({
        iterations: (simulation.last_half_step() - 1) / 2,
        reason: simulation.stop_reason(),
      });
    },
  );
});
