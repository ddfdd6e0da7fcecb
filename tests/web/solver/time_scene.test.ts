import { describe, expect, it } from 'vitest';
import { timeScene } from '../../../web/src/solver/time_scene.ts';
import { solver } from '../../support/open_simulation.ts';
import { net, usualParameters } from '../../support/small_scenes.ts';

describe('timeScene', () => {
  it('times the precomputation and a time step', () => {
    const scene = net(5);
    const outcome = timeScene(solver, scene, scene, usualParameters);
    expect(outcome.ok && outcome.value.precomputation > 0 && outcome.value.step > 0).toBe(true);
  });

  it('hands a refusal on', () => {
    const scene = net(5);
    const outcome = timeScene(solver, scene, scene, { ...usualParameters, k: -1 });
    expect(outcome).toMatchObject({ ok: false, status: { code: 'not_positive', field: 'k', value: -1 } });
  });
});
