import { expect, onTestFinished } from 'vitest';
import { loadSolver } from '../../web/headless/load_solver.ts';
import type { Parameters, Simulation, Status } from '../../web/src/solver/module.ts';
import type { MovingScene, SmallScene } from './small_scenes.ts';

export const solver = await loadSolver();

/** Matches every status, with all of its fields. */
export const anyStatus = {
  code: expect.any(String),
  field: expect.any(String),
  index: expect.any(Number),
  value: expect.any(Number),
  limit: expect.any(Number),
};

export function expectOk(status: Status): void {
  expect(status).toEqual({ code: 'ok', field: '', index: -1, value: 0, limit: 0 });
}

/** A simulation of the scene at rest, deleted when the test is over. */
export function openSimulation({ V, E, m, pinned }: SmallScene, parameters: Parameters): Simulation {
  const simulation = new solver.Simulation();
  onTestFinished(() => simulation.delete());
  expectOk(simulation.set_scene(V, E, m, pinned, parameters));
  return simulation;
}

/** The same in the middle of the scene's motion, at predict. */
export function openMoving(scene: MovingScene): Simulation {
  const simulation = openSimulation(scene, scene.parameters);
  expectOk(simulation.set_pins(scene.pinned, scene.targets));
  expectOk(simulation.set_state(1, scene.p_curr, scene.p_prev, 0));
  return simulation;
}

/** Everything about the cursor that must come back bit for bit, copied. */
export function place(simulation: Simulation) {
  return {
    step: simulation.step_number(),
    half_step: simulation.half_step(),
    p: simulation.p().slice(),
    p_before: simulation.p_before().slice(),
    p_curr: simulation.p_curr().slice(),
    p_prev: simulation.p_prev().slice(),
    d: simulation.d().slice(),
  };
}

/** max over all entries of |a − b|. */
export function distance(a: ArrayLike<number>, b: ArrayLike<number>): number {
  expect(a.length).toBe(b.length);
  return Array.from(a, (value, index) => Math.abs(value - b[index])).reduce((x, y) => Math.max(x, y), 0);
}
