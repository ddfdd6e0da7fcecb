import { beforeEach, describe, expect, it } from 'vitest';
import { openedScenes } from '../../../../../web/src/app/scene_library.ts';
import type { Adjustable } from '../../../../../web/src/app/state.ts';
import { trajectory } from '../../../../../web/src/labs/lesson/figures/trajectory.ts';
import type { Scene } from '../../../../../web/src/scene/scene.ts';
import { sceneParameters } from '../../../../../web/src/solver/scene_parameters.ts';
import { lessonSolver } from '../../../../support/lesson_solver.ts';
import { openScene } from '../../../../support/open_scene.ts';
import { openSimulation } from '../../../../support/open_simulation.ts';
import { traceRows } from '../../../../support/trace_rows.ts';

let patch: Scene;

beforeEach(async () => {
  patch = await openScene('patch');
  openedScenes.value = [patch];
});

const fall = (parameters: Partial<Adjustable>, steps: number) =>
  trajectory(lessonSolver(), { scene: 'patch', parameters }, steps);

// What section 5 says can be seen.

describe('too few rounds', () => {
  it('make the patch sink slowly instead of dropping and swinging', async () => {
    const lowest = async (iterations: number) => (await fall({ k: 2000, iterations }, 20)).map(({ p }) => p[3 * 7 + 1]);
    const [slow, right] = [await lowest(1), await lowest(50)];
    expect(slow).toEqual(slow.toSorted((a, b) => b - a)); // always downwards
    expect(right).not.toEqual(right.toSorted((a, b) => b - a)); // back up, too
    // Within 20 steps the one has fallen less than a third of where the other has been.
    expect(Math.min(...slow) + 0.8).toBeGreaterThan((Math.min(...right) + 0.8) / 3);
  });
});

describe('the rounds that are enough', () => {
  it('grow with the stiffness number', async () => {
    const rounds: number[] = [];
    for (const k of [100, 400, 1600, 3200]) {
      const last = (await fall({ k, iterations: 1000, stop_gradient: 0.1 }, 8)).at(-1);
      expect(last?.stopReason).toBe('gradient');
      rounds.push(last?.iterations ?? 0);
    }
    expect(rounds).toEqual(rounds.toSorted((a, b) => a - b));
    expect(rounds[3]).toBeGreaterThan(5 * rounds[0]);
  });
});

describe('every round', () => {
  it('leaves about the same fraction of the unbalanced force', () => {
    const simulation = openSimulation(patch, { ...sceneParameters(patch), k: 2000 });
    for (let step = 0; step < 6; step++) simulation.step();
    simulation.next_step();
    simulation.seek(101);
    const left = traceRows(simulation).filter(({ half_step }) => half_step % 2 === 0 && half_step > 20);
    const fractions = left.slice(1).map(({ gradient }, round) => gradient / left[round].gradient);
    // From round 10 on the slowest part of the error is all that is left: the fractions agree to a few per cent.
    expect(Math.min(...fractions)).toBeGreaterThan(0.95 * Math.max(...fractions));
    expect(Math.max(...fractions)).toBeLessThan(1);
  });
});
