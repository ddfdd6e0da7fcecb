import { onTestFinished } from 'vitest';
import type { Mistake, MistakenSimulation } from '../../web/src/solver/mistaken_simulation.ts';
import type { Parameters } from '../../web/src/solver/module.ts';
import { expectOk, solver } from './open_simulation.ts';
import type { SmallScene } from './small_scenes.ts';

/** A simulation of the scene at rest that makes a mistake, deleted when the test is over. */
export function openMistaken(
  { V, E, m, pinned }: SmallScene,
  parameters: Parameters,
  mistake: Mistake,
): MistakenSimulation {
  const simulation = new solver.MistakenSimulation();
  onTestFinished(() => simulation.delete());
  expectOk(simulation.set_scene(V, E, m, pinned, parameters, mistake));
  return simulation;
}
