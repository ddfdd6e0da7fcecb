import type { SolverModule } from './module.ts';
import { angularFrequency, demand, type OneSpring, toConvergence, type Way, withOneSpring } from './one_spring.ts';

/** An error of positions, m, at the time T for each number of time steps. */
export interface Errors {
  way: Way;
  errors: readonly { delta_t: number; error: number }[];
}

/** One spring, moved up to the time T by several methods with shorter and shorter steps. */
export interface Experiment {
  spring: OneSpring;
  /** s. */
  T: number;
  ways: readonly Way[];
}

export const cases = ['line', 'swing'] as const;
export type Case = (typeof cases)[number];

const once = { iterations: 1 };
const newton: Way = { method: 'newton', iterations: toConvergence };

export const experiments: Record<Case, Experiment> = {
  // A period of 1 s. Errors to first order go with cos ωT or with sin ωT: at five eighths of a period neither is near 0.
  line: {
    spring: { k: 4 * Math.PI ** 2, m: 1, r: 1, gravity: 0, start: [1.2, 0] },
    T: 5 / 8,
    ways: [
      { method: 'forward-euler', ...once },
      { method: 'symplectic-euler', ...once },
      { method: 'linearly-implicit', ...once },
      newton,
      { method: 'local-global', ...once },
    ],
  },
  // Let go level at its rest length, it falls and turns. At T it is past its lowest point.
  swing: {
    spring: { k: 400, m: 1, r: 1, gravity: 9.8, start: [1, 0] },
    T: 0.8,
    ways: [
      newton,
      { method: 'linearly-implicit', ...once },
      ...[1, 2, 10, 50].map((iterations): Way => ({ method: 'local-global', iterations })),
    ],
  },
};

/** Time steps up to T. */
export const stepCounts = [16, 32, 64, 128, 256, 512, 1024, 2048];

/** Of the reference, and twice as many: enough for all digits but the last few. */
const referenceSteps = 8192;

/** How far each method is from the right place at T. */
export function orderOfAccuracy(solver: SolverModule, name: Case): Errors[] {
  const { spring, T, ways } = experiments[name];
  const right = name === 'line' ? placeOnLine(spring, T) : reference(solver, spring, T, referenceSteps);
  return ways.map((way) => ({
    way,
    errors: stepCounts.map((steps) => {
      const p = placeAfter(solver, spring, way, T, steps);
      return { delta_t: T / steps, error: Math.hypot(p[0] - right[0], p[1] - right[1]) };
    }),
  }));
}

/** m: where the method has the mass at T. */
export function placeAfter(
  solver: SolverModule,
  spring: OneSpring,
  way: Way,
  T: number,
  steps: number,
): readonly [number, number] {
  return withOneSpring(solver, spring, way, T / steps, (simulation) => {
    for (let step = 0; step < steps; step++) demand(simulation.step());
    const p = simulation.p();
    return [p[3], p[4]];
  });
}

/** x(T) = r + (x(0) − r) cos ωT. */
function placeOnLine(spring: OneSpring, T: number): readonly [number, number] {
  const { r, start } = spring;
  return [r + (start[0] - r) * Math.cos(angularFrequency(spring) * T), 0];
}

/**
 * Symplectic Euler whose first step has half the force: that makes the velocities those of half a step later, and the method Störmer and Verlet's,
 * whose error is a series in Δt². With twice as many steps the first term is four times smaller: (4 fine − coarse)/3 is free of it.
 */
export function reference(
  solver: SolverModule,
  spring: OneSpring,
  T: number,
  steps: number,
): readonly [number, number] {
  const coarse = verlet(solver, spring, T, steps);
  const fine = verlet(solver, spring, T, 2 * steps);
  return [(4 * fine[0] - coarse[0]) / 3, (4 * fine[1] - coarse[1]) / 3];
}

function verlet(solver: SolverModule, spring: OneSpring, T: number, steps: number): readonly [number, number] {
  return withOneSpring(solver, spring, { method: 'symplectic-euler', ...once }, T / steps, (simulation) => {
    const p_curr = simulation.p_curr().slice();
    demand(simulation.step());
    // The whole first step is Δt² M⁻¹ f: half of it backwards, and the step before is where the mass would have come from.
    const p_prev = p_curr.map((at, c) => at + (simulation.p()[c] - at) / 2);
    demand(simulation.set_state(1, p_curr, p_prev, 0));
    for (let step = 0; step < steps; step++) demand(simulation.step());
    const p = simulation.p();
    return [p[3], p[4]];
  });
}
