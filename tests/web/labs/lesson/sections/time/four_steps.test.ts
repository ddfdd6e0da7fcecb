import { expect, it } from 'vitest';
import { totalEnergy } from '../../../../../../web/src/labs/lesson/figures/total_energy.ts';
import { steps } from '../../../../../../web/src/labs/lesson/sections/time/steps.ts';
import { sceneParameters } from '../../../../../../web/src/solver/scene_parameters.ts';
import { openScene } from '../../../../../support/open_scene.ts';
import { expectOk, openSimulation } from '../../../../../support/open_simulation.ts';

const triangle = await openScene('triangle');

/** J: what the energy has changed by after each time step of five seconds. */
function changes(delta_t: number): number[] {
  const s = openSimulation(triangle, { ...sceneParameters(triangle), delta_t });
  const energy = (now: Float64Array, before: Float64Array) => {
    const evaluations = [{ ...s.objective_at(now), gradient: new Float64Array() }];
    return totalEnergy({ m: triangle.m, evaluations }, { time: 0, delta_t, now, before });
  };
  const start = energy(triangle.V, triangle.V);
  let before = triangle.V;
  return Array.from({ length: Math.round(5 / delta_t) }, () => {
    expectOk(s.step());
    const now = s.p().slice();
    const change = energy(now, before) - start;
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
