import { expect, test } from 'vitest';
import { parametersOn } from '../../../web/src/app/state.ts';
import { openScene } from '../../support/open_scene.ts';
import { expectOk, openSimulation } from '../../support/open_simulation.ts';
import { traceRows } from '../../support/trace_rows.ts';

test('the springs lab solves Q p = b of a scene with dashpots too: it leaves them out, as its formulas do', async () => {
  const cloth = await openScene('cloth');
  expect(cloth.damping).toBeGreaterThan(0);
  const simulation = openSimulation(cloth, parametersOn(cloth, {}));
  expectOk(simulation.seek(2));
  // b is some kN at most, rounded; with dashpots nothing would solve Q p = b, and the residual be no number.
  expect(traceRows(simulation)[2].residual).toBeLessThan(1e-9);
});
