import type { SolverModule } from './module.ts';
import { angularFrequency, demand, type OneSpring, type Way, withOneSpring } from './one_spring.ts';

export const energyMethods = ['forward-euler', 'symplectic-euler', 'newton'] as const;
export type EnergyMethod = (typeof energyMethods)[number];

/** The total energy after every time step over that at the start. */
export type EnergyRatios = Record<EnergyMethod, readonly number[]>;

/** Periods of the motion. */
export const shownPeriods = 5;

/** Beyond so much of its first energy a run is over. With it the mass is still far from the fixed end, where the spring would turn around. */
export const explodedRatio = 100;

/** A period of 1 s, stretched by a hundredth of its length. */
export const spring: OneSpring = { k: 4 * Math.PI ** 2, m: 1, r: 1, gravity: 0, start: [1.01, 0] };

/** One spring on a line by the three methods that differ there, for each Δt·ω. */
export function energyOfOneSpring(solver: SolverModule, products: readonly number[]): EnergyRatios[] {
  return products.map((product) => {
    const ratios = (method: EnergyMethod) => energyRatios(solver, { method, iterations: 100 }, product);
    return {
      'forward-euler': ratios('forward-euler'),
      'symplectic-euler': ratios('symplectic-euler'),
      newton: ratios('newton'),
    };
  });
}

function energyRatios(solver: SolverModule, way: Way, product: number): number[] {
  const delta_t = product / angularFrequency(spring);
  const steps = Math.ceil((shownPeriods * 2 * Math.PI) / product);
  return withOneSpring(solver, spring, way, delta_t, (simulation) => {
    const total = () => {
      const { kinetic, springs } = simulation.energy();
      return kinetic + springs;
    };
    const first = total();
    const ratios = [1];
    while (ratios.length <= steps && ratios[ratios.length - 1] < explodedRatio) {
      demand(simulation.step());
      ratios.push(total() / first);
    }
    return ratios;
  });
}
