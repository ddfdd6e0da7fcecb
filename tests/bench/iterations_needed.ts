import { compareColumns, type Method, type Simulation } from '../../web/src/solver/module.ts';

/** Of the decrease of E: what rounding may cost where two methods end at the same minimum. */
const tolerance = 1e-9;
/** A method that takes more gets nowhere. */
const mostIterations = 64;

/** J, at most 0: how far so many iterations of a method lower E in the current time step. */
export function decrease(simulation: Simulation, method: Method, iterations: number): number {
  return Math.min(...changes(simulation, method, iterations));
}

/** Iterations of a method in the current time step until E has fallen as far as the target; infinite where it does not. */
export function iterationsNeeded(simulation: Simulation, method: Method, target: number): number {
  // Twice as many each time, because those of Newton's method are dear.
  for (let most = 1; most <= mostIterations; most *= 2) {
    const reached = changes(simulation, method, most).findIndex((change) => change <= target * (1 - tolerance));
    if (reached >= 0) return Math.max(1, reached);
  }
  return Number.POSITIVE_INFINITY;
}

/** J: E(p^k) − E(p^0) for k = 0, 1, …; none where the method is refused, because it would not fit the memory. */
function changes(simulation: Simulation, method: Method, iterations: number): number[] {
  const { rows } = simulation.compare(method, iterations);
  const column = compareColumns.indexOf('change');
  return Array.from(rows).filter((_, c) => c % compareColumns.length === column);
}
