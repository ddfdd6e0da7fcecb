import type { Profile } from './frame.ts';
import type { Simulation } from './module.ts';
import { timeOf } from './time_of.ts';

/** ms. In a page the clock ticks every 0.1 ms; longer would keep the next picture waiting. */
const leastTimed_ms = 0.5;

/** What one iteration's two halves take. */
export function measureIteration(simulation: Simulation): Profile {
  return {
    local: timeOf((times) => simulation.rehearse_local_step(times), leastTimed_ms),
    global: timeOf((times) => simulation.rehearse_global_step(times), leastTimed_ms),
  };
}
