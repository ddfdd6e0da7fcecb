import { newSolver, startSolver } from '../../../app/start_solver.ts';
import type { SolverClient } from '../../../solver/client.ts';
import type { Checkpoint, Inspection, Opened, Outcome, Problem, Request } from '../../../solver/protocol.ts';

/** A request with all it builds on. Figures are small, so opening their problem anew each time costs less than keeping a worker for each. */
export interface Moment {
  problem: Problem;
  request: Request;
  /** Null: at rest. */
  from: Checkpoint | null;
}

/** The one solver of all figures: they take turns, and nothing of one is left when the next one asks. */
export class LessonSolver {
  private readonly client: SolverClient;
  private last: Promise<unknown> = Promise.resolve();

  constructor(client: SolverClient) {
    this.client = client;
  }

  /** Throws Obstacle, or SolverCrash; the next request then finds a new worker. */
  run({ problem, request, from }: Moment): Promise<Outcome<Opened>> {
    return this.inTurn(() => this.client.open(problem, request, from));
  }

  /** What `run` would leave open, looked at. Null where it is refused. Throws as `run` does. */
  inspect({ problem, request, from }: Moment, points: readonly Float64Array[]): Promise<Inspection | null> {
    return this.inTurn(async () => {
      const outcome = await this.client.open(problem, request, from);
      return outcome.ok ? this.client.inspect(points) : null;
    });
  }

  private inTurn<T>(task: () => Promise<T>): Promise<T> {
    const turn = this.last.then(() => startSolver(this.client)).then(task);
    this.last = turn.catch(() => {}); // whoever asked hears of it
    return turn;
  }
}

export const lessonSolver = new LessonSolver(newSolver());
