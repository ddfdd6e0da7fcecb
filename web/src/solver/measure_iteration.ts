import type { Profile } from './frame.ts';
import type { Simulation } from './module.ts';

/** ms. In a page the clock ticks every 0.1 ms; longer would keep the next picture waiting. */
const leastTimed_ms = 0.5;

/** What one iteration's two halves take. */
export function measureIteration(simulation: Simulation): Profile {
  return {
    local: timeOf((times) => simulation.rehearse_local_step(times)),
    global: timeOf((times) => simulation.rehearse_global_step(times)),
  };
}

/** ms of one repetition, among as many as the clock needs; the better of two, since the first finds the caches cold. */
function timeOf(repeat: (times: number) => void): number {
  const timed = (times: number) => {
    const started = performance.now();
    repeat(times);
    return performance.now() - started;
  };
  for (let times = 1; ; times *= 2) {
    const first = timed(times);
    if (first >= leastTimed_ms) return Math.min(first, timed(times)) / times;
  }
}
