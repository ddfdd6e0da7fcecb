import { type Followed, followTargets } from './follow_targets.ts';
import { type IkMethod, type IkOutcome, type IkTask, ikMethods } from './inverse_kinematics.ts';
import type { SolverModule } from './module.ts';
import type { Outcome } from './protocol.ts';

export const precisions = ['double', 'single'] as const satisfies readonly IkTask['precision'][];

/** What one method took for all targets in one precision. */
export interface IterationCounts {
  method: IkMethod;
  precision: IkTask['precision'];
  /** #T: for each target, curve after curve. */
  iterations: Int32Array;
  /** #T. */
  outcomes: IkOutcome[];
  /** m. */
  largestError: number;
  /** ms: a target on average, with all that the solver records. */
  time: number;
}

/** Every method in every precision along every curve, #T×3, m; on each curve the first target is looked for from the hanging chain, every other from the pose before. `now`: ms. */
export function countIterations(
  solver: Pick<SolverModule, 'inverse_kinematics'>,
  task: IkTask,
  curves: readonly Float64Array[],
  now: () => number,
): Outcome<IterationCounts[]> {
  const counts: IterationCounts[] = [];
  for (const method of ikMethods)
    for (const precision of precisions) {
      const begin = now();
      const runs: Followed[] = [];
      for (const targets of curves) {
        const run = followTargets(solver, { ...task, method, precision }, targets);
        if (!run.ok) return run;
        runs.push(run.value);
      }
      const outcomes = runs.flatMap((run) => run.outcomes);
      counts.push({
        method,
        precision,
        iterations: Int32Array.from(runs.flatMap(({ iterations }) => [...iterations])),
        outcomes,
        largestError: Math.max(...runs.flatMap(({ errors }) => [...errors])),
        time: (now() - begin) / outcomes.length,
      });
    }
  return { ok: true, value: counts };
}
