import { type Remote, wrap } from 'comlink';
import type { TimingService } from '../solver/timing_worker.ts';
import { Obstacle } from './obstacle.ts';
import { fetchSolver } from './start_solver.ts';

/** What a caller does with the worker. */
export type TimingTask<T> = (service: Remote<TimingService>) => Promise<T>;

/** Has a worker of its own do something, and ends it. Null when `stop` ended it before. Throws when the worker cannot be had or fails. */
export async function inTimingWorker<T>(stop: AbortSignal, task: TimingTask<T>): Promise<T | null> {
  const wasmBinary = await fetchSolver();
  if (stop.aborted) return null;
  const worker = new Worker(new URL('../solver/timing_worker.ts', import.meta.url), { type: 'module' });
  const stopped = new Promise<null>((resolve) => stop.addEventListener('abort', () => resolve(null)));
  const failed = new Promise<never>((_, reject) => {
    // Without a message it is the script that did not come.
    worker.addEventListener('error', ({ message }) =>
      reject(message ? new Error(message) : new Obstacle('page.errors.solverStart', { reason: 'timing_worker' })),
    );
  });
  const service = wrap<TimingService>(worker);
  try {
    return await Promise.race([service.start(wasmBinary).then(() => task(service)), stopped, failed]);
  } finally {
    worker.terminate();
  }
}
