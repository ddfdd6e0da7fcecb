import { expect, onTestFinished, test } from 'vitest';
import type { Stage } from '../../web/src/solver/module.ts';
import { expectOk, solver } from '../support/open_simulation.ts';
import { sceneFromRule } from '../support/scene_from_rule.ts';
import { usualParameters } from '../support/small_scenes.ts';
import { tetrahedralBlock } from '../support/tetrahedral_block.ts';

// Large enough to be told of more than once.
const { V, E, m, pinned } = await sceneFromRule(tetrahedralBlock());
const fast = { ...usualParameters, path: 'fast' } as const;

/** A simulation, and what it tells: every stage with its fractions. */
function watched() {
  const simulation = new solver.Simulation();
  onTestFinished(() => simulation.delete());
  const stages: [Stage, number[]][] = [];
  simulation.set_progress((stage, fraction) => {
    expect(simulation.vertex_count()).toBe(m.length);
    if (stages.at(-1)?.[0] !== stage) stages.push([stage, []]);
    stages.at(-1)?.[1].push(fraction);
  });
  return { simulation, stages };
}

test('opening a scene tells that the order is sought, then how far the factor is', () => {
  const { simulation, stages } = watched();
  expectOk(simulation.set_scene(V, E, m, pinned, fast));
  expect(stages.map(([stage]) => stage)).toEqual(['ordering', 'factorising']);
  const fractions = stages[1][1];
  expect(fractions.length).toBeGreaterThan(1);
  expect(fractions).toEqual(fractions.toSorted((a, b) => a - b));
  expect(fractions[0]).toBeGreaterThan(0);
  expect(fractions.at(-1)).toBeLessThanOrEqual(1);
});

test('another k needs no other order; a step needs neither', () => {
  const { simulation, stages } = watched();
  expectOk(simulation.set_scene(V, E, m, pinned, fast));
  stages.length = 0;
  expectOk(simulation.set_parameters({ ...fast, k: 2 * fast.k }));
  expect(stages.map(([stage]) => stage)).toEqual(['factorising']);
  stages.length = 0;
  expectOk(simulation.step());
  expect(stages).toEqual([]);
});

test('the plain path tells that it factorises, and not how far it is', () => {
  const { simulation, stages } = watched();
  expectOk(simulation.set_scene(V, E, m, pinned, { ...fast, path: 'plain' }));
  expect(stages).toEqual([['factorising', [0]]]);
});
