import { findScene } from '../../../app/scene_library.ts';
import { parametersOn, pinsOn } from '../../../app/state.ts';
import type { Frame } from '../../../solver/frame.ts';
import type { Checkpoint } from '../../../solver/protocol.ts';
import type { FigureSettings } from './figure_session.ts';
import type { LessonSolver } from './lesson_solver.ts';

/** The ends of the first so many time steps from rest; fewer where the solver refuses one. Throws SolverCrash and SceneProblem. */
export async function trajectory(
  solver: LessonSolver,
  { scene: name, parameters = {}, pins }: FigureSettings,
  steps: number,
): Promise<Frame[]> {
  const scene = await findScene(name);
  const request = {
    parameters: parametersOn(scene, parameters),
    pins: pinsOn(scene, pins ? [...pins] : null),
    command: { kind: 'play', steps: 1 },
    selectedVertex: null,
    wholeTrace: false,
    profile: false,
  } as const;
  const frames: Frame[] = [];
  let from: Checkpoint | null = null;
  while (frames.length < steps) {
    const outcome = await solver.run({ problem: scene, request, from });
    if (!outcome.ok) break;
    frames.push(outcome.value.frame);
    from = outcome.value.checkpoint;
  }
  return frames;
}
