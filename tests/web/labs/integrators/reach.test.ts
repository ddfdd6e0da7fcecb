import { expect, test } from 'vitest';
import { comparedLimits, comparedParameters } from '../../../../web/src/app/integrators.ts';
import { reachOf } from '../../../../web/src/labs/integrators/reach.ts';
import { sceneParameters } from '../../../../web/src/solver/scene_parameters.ts';
import { openScene } from '../../../support/open_scene.ts';

test('the cloth has the sliders of its lab', () => {
  const range = (name: (typeof comparedParameters)[number]) => Object.values(reachOf('cloth', name, 0.2));
  expect(['mass_scale', 'k', 'damping', 'gravity'].map((name) => range(name as never))).toEqual([
    [0.5, 10],
    [10, 300],
    [0.1, 10],
    [0.1, 1],
  ]);
});

test.each(['cloth', 'rabbit', 'net', 'flag'])(
  'every slider of %s reaches its own value and stays within what is allowed',
  async (name) => {
    const own = sceneParameters(await openScene(name));
    for (const parameter of comparedParameters) {
      const { min, max } = reachOf(name, parameter, own[parameter]);
      expect(min).toBeLessThanOrEqual(own[parameter]);
      expect(max).toBeGreaterThan(own[parameter]);
      expect(min).toBeGreaterThanOrEqual(comparedLimits[parameter].min);
      expect(max).toBeLessThanOrEqual(comparedLimits[parameter].max);
    }
  },
);
