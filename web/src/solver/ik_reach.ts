import { type IkAnswer, type IkMethod, type IkTask, ikMethods } from './inverse_kinematics.ts';
import type { SolverModule } from './module.ts';
import type { Outcome } from './protocol.ts';

/** What became of one target by one method. */
export interface Reach {
  /** As the solver does it: first it asks how far the target is. */
  tested: IkAnswer;
  /** The same for a target close by. */
  beside: IkAnswer;
  /** Without asking: it only searches. */
  untested: IkAnswer;
  /** Without asking, for the same target once more from where that search ended, as in the next frame. */
  again: IkAnswer;
}

/** One target by all methods, with the question for its distance and without. `beside`: m, the target close by. */
export function reachByAll(
  solver: Pick<SolverModule, 'inverse_kinematics'>,
  task: IkTask,
  beside: Float64Array,
): Outcome<Record<IkMethod, Reach>> {
  // Where joints are limited a straight arm may not be allowed, so the solver searches; half a turn limits nothing.
  const searching = { bend_limits: new Float64Array(task.offsets.length / 3).fill(Math.PI) };
  const reaches: [IkMethod, Reach][] = [];
  for (const method of ikMethods) {
    const solve = (change: Partial<IkTask>) => solver.inverse_kinematics({ ...task, method, ...change });
    const [tested, close, untested] = [solve({}), solve({ target: beside }), solve(searching)];
    for (const { status } of [tested, close, untested]) if (status.code !== 'ok') return { ok: false, status };
    const again = solve({ ...searching, start: new Float64Array(), start_q: untested.answer.q });
    reaches.push([
      method,
      { tested: tested.answer, beside: close.answer, untested: untested.answer, again: again.answer },
    ]);
  }
  return { ok: true, value: Object.fromEntries(reaches) as Record<IkMethod, Reach> };
}
