import type { Inspection } from '../../../solver/protocol.ts';

/** Where everything is, and where it was a time step before. */
export interface Instant {
  /** s */
  time: number;
  delta_t: number;
  /** #V×3, m. */
  now: Float64Array;
  before: Float64Array;
}

/** J: kinetic energy, and the potential energy of springs and gravity. The inspection is of `now` alone. */
export function totalEnergy(
  { m, evaluations: [{ potential, external }] }: Pick<Inspection, 'm' | 'evaluations'>,
  { now, before, delta_t }: Instant,
): number {
  const kinetic = now.reduce((sum, x, c) => sum + 0.5 * m[Math.floor(c / 3)] * ((x - before[c]) / delta_t) ** 2, 0);
  return kinetic + potential + external;
}
