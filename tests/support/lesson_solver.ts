import { LessonSolver } from '../../web/src/labs/lesson/figures/lesson_solver.ts';
import type { SolverClient } from '../../web/src/solver/client.ts';
import { SolverSession } from '../../web/src/solver/solver_session.ts';
import { solver } from './open_simulation.ts';

/** The lesson's solver without a worker: the real module answers at once. */
export function lessonSolver(): LessonSolver {
  const session = new SolverSession(solver, () => {});
  const client: Pick<SolverClient, 'start' | 'open' | 'inspect'> = {
    start: async () => {},
    open: async (problem, request, from = null) => session.open(problem, request, from),
    inspect: async (points) => session.inspect(points),
  };
  return new LessonSolver(client as unknown as SolverClient);
}
