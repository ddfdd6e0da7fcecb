import { totalEnergy } from '../../web/src/labs/lesson/figures/total_energy.ts';
import type { Simulation } from '../../web/src/solver/module.ts';

/** J: kinetic and potential energy at `now`, Δt after `before`, both #V×3, m. */
export function energyOf(s: Simulation, delta_t: number, now: Float64Array, before: Float64Array): number {
  const evaluations = [{ ...s.objective_at(now), gradient: new Float64Array() }];
  return totalEnergy({ m: s.m().slice(), evaluations }, { time: 0, delta_t, now, before });
}
