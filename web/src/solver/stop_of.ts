import type { Parameters, StopReason } from './module.ts';
import type { MethodRun } from './protocol.ts';

/** How a time step ends. */
export interface Stop {
  /** Made. */
  iterations: number;
  reason: StopReason;
}

/** What ends a time step; a threshold of 0 does not. */
export type StoppingRules = Pick<Parameters, 'iterations' | 'stop_gradient' | 'stop_decrease'>;

/**
 * Where the solver ends this time step by that method under these rules, as wasm/core/stopping_rule.h has them; a test holds the two together.
 * Null where the run was given up before it came there.
 */
export function stopOf(run: MethodRun, { iterations, stop_gradient, stop_decrease }: StoppingRules): Stop | null {
  const last = run.change.length - 1;
  const plain = run.method === 'local-global' && stop_gradient === 0 && stop_decrease === 0;
  if (plain) return last >= iterations || run.converged ? { iterations, reason: 'iterations' } : null; // they never look at E
  for (let k = 0; k <= last; k++) {
    const stopped = (reason: StopReason): Stop => ({ iterations: k, reason });
    if (run.converged && k === last) return stopped('rounding');
    if (stop_gradient > 0 && run.gradient[k] <= stop_gradient) return stopped('gradient');
    if (stop_decrease > 0 && run.decrease[k] <= stop_decrease) return stopped('decrease');
    if (k >= iterations) return stopped('iterations');
  }
  return null;
}
