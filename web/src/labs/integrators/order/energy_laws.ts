import type { EnergyMethod } from '../../../solver/energy_of_one_spring.ts';

/** By which factor the energy changes in a time step; or between which multiples of the first it stays. */
export type EnergyLaw = { kind: 'factor'; factor: number } | { kind: 'band'; least: number; most: number };

/** What theory says of a mass that moves along its spring, with the product Δt·ω. */
export function predictedLaw(method: EnergyMethod, product: number): EnergyLaw {
  const gain = 1 + product ** 2;
  switch (method) {
    case 'forward-euler':
      return { kind: 'factor', factor: gain };
    case 'newton':
      return { kind: 'factor', factor: 1 / gain };
    case 'symplectic-euler':
      // It keeps v² − Δtω² x v + ω² x²: an ellipse, which leans the more the longer Δt, and opens at 2.
      return product < 2
        ? { kind: 'band', least: 1 / (1 + product / 2), most: 1 / (1 - product / 2) }
        : { kind: 'band', least: 0, most: Number.POSITIVE_INFINITY };
  }
}

/** The same of the energies, over the first one, that were measured after each time step. */
export function measuredLaw(method: EnergyMethod, ratios: readonly number[]): EnergyLaw {
  if (method === 'symplectic-euler') return { kind: 'band', least: Math.min(...ratios), most: Math.max(...ratios) };
  return { kind: 'factor', factor: ratios[ratios.length - 1] ** (1 / (ratios.length - 1)) };
}

/** A factor per time step as one per period. */
export function perPeriod(factor: number, product: number): number {
  return factor ** ((2 * Math.PI) / product);
}
