import { expect, it } from 'vitest';
import { steps } from '../../../../../../web/src/labs/lesson/sections/time/steps.ts';
import { sceneParameters } from '../../../../../../web/src/solver/scene_parameters.ts';
import { energyOf } from '../../../../../support/energy_of.ts';
import { openScene } from '../../../../../support/open_scene.ts';
import { expectOk, openSimulation } from '../../../../../support/open_simulation.ts';

const triangle = await openScene('triangle');

/** J: what the energy has changed by after each time step of five seconds. */
function changes(delta_t: number): number[] {
  const s = openSimulation(triangle, { ...sceneParameters(triangle), delta_t });
  const start = energyOf(s, delta_t, triangle.V, triangle.V);
  let before = triangle.V;
  return Array.from({ length: Math.round(5 / delta_t) }, () => {
    expectOk(s.step());
    const now = s.p().slice();
    const change = energyOf(s, delta_t, now, before) - start;
    before = now;
    return change;
  });
}

it('no time step adds energy', () => {
  for (const { delta_t } of steps) {
    const curve = changes(delta_t);
    const gains = curve.map((change, at) => change - (curve[at - 1] ?? 0));
    expect(Math.max(...gains)).toBeLessThan(1e-4); // J: K = 50 iterations leave that much of a time step of 1 s undone
  }
});

it('the longer the step, the more is lost in five seconds', () => {
  const lost = steps.map(({ delta_t }) => -(changes(delta_t).at(-1) as number));
  expect(lost).toEqual([...lost].sort((a, b) => a - b));
  expect(lost[0]).toBeLessThan(0.9 * lost[1]); // as plainly as the curves show it
});
