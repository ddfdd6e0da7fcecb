import type { IkAnswer, IkOutcome, IkTask } from './inverse_kinematics.ts';
import type { SolverModule } from './module.ts';
import type { Outcome } from './protocol.ts';

/** How a chain goes from target to target. */
export interface Followed {
  /** #T×#joints×3, m, and #T×#joints×4, (x, y, z, w). */
  x: Float64Array;
  q: Float64Array;
  /** #T, m: between end effector and target. */
  errors: Float64Array;
  /** #T. */
  iterations: Int32Array;
  outcomes: IkOutcome[];
}

/** Without the events, which for a long curve would fill the memory. */
type Answered = Pick<IkAnswer, 'x' | 'q' | 'error' | 'iterations' | 'outcome'>;

/** To the first of several targets the arm goes as it likes: a turn limit holds between targets. */
export function toFirst(task: IkTask): IkTask {
  return { ...task, turn_limit: Math.PI };
}

/** One target after the other, each from the pose that the one before has left; `targets` #T×3, m. The first one that is refused refuses all. */
export function followTargets(
  solver: Pick<SolverModule, 'inverse_kinematics'>,
  task: IkTask,
  targets: Float64Array,
): Outcome<Followed> {
  const answers: Answered[] = [];
  for (let i = 0; i < targets.length / 3; i++) {
    const before = answers.at(-1);
    const from = before ? { ...task, start: new Float64Array(), start_q: before.q } : toFirst(task);
    const { status, answer } = solver.inverse_kinematics({
      ...from,
      target: targets.subarray(3 * i, 3 * i + 3),
    });
    if (status.code !== 'ok') return { ok: false, status };
    const { x, q, error, iterations, outcome } = answer;
    answers.push({ x, q, error, iterations, outcome });
  }
  return {
    ok: true,
    value: {
      x: Float64Array.from(answers.flatMap(({ x }) => [...x])),
      q: Float64Array.from(answers.flatMap(({ q }) => [...q])),
      errors: Float64Array.from(answers, ({ error }) => error),
      iterations: Int32Array.from(answers, ({ iterations }) => iterations),
      outcomes: answers.map(({ outcome }) => outcome),
    },
  };
}
