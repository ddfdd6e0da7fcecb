import type { Simulation } from '../../web/src/solver/module.ts';
import { succeed } from './succeed.ts';

/** A place in a motion: a time step that is to be done, and what is known before it. */
export interface Instant {
  step: number;
  /** #V×3, m. */
  p_curr: Float64Array;
  p_prev: Float64Array;
}

/** The time steps looked at: scenes fall, swing, and come to rest. */
const steps = [5, 10, 20, 40, 80];
export const lastStep = steps[steps.length - 1];

/** Runs a simulation from rest to the end of the last of those time steps. */
export function playThrough(simulation: Simulation): Instant[] {
  const instants: Instant[] = [];
  for (let step = 1; step <= lastStep; step++) {
    succeed(simulation.step());
    if (!steps.includes(step)) continue;
    instants.push({ step, p_curr: simulation.p_curr().slice(), p_prev: simulation.p_prev().slice() });
  }
  return instants;
}

export function restore(simulation: Simulation, { step, p_curr, p_prev }: Instant): void {
  succeed(simulation.set_state(step, p_curr, p_prev, 0));
}
