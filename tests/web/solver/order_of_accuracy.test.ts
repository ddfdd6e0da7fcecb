import { describe, expect, it } from 'vitest';
import { slopeOf } from '../../../web/src/labs/integrators/order/lines.ts';
import type { Way } from '../../../web/src/solver/one_spring.ts';
import { toConvergence, withOneSpring } from '../../../web/src/solver/one_spring.ts';
import {
  type Case,
  type Errors,
  experiments,
  orderOfAccuracy,
  placeAfter,
  reference,
  stepCounts,
} from '../../../web/src/solver/order_of_accuracy.ts';
import { solver } from '../../support/open_simulation.ts';

const measured: Record<Case, Errors[]> = {
  line: orderOfAccuracy(solver, 'line'),
  swing: orderOfAccuracy(solver, 'swing'),
};
const newton: Way = { method: 'newton', iterations: toConvergence };
const localGlobal = (iterations: number): Way => ({ method: 'local-global', iterations });

function of(name: Case, { method, iterations }: Way): Errors {
  const found = measured[name].find(({ way }) => way.method === method && way.iterations === iterations);
  if (!found) throw new Error(`${name} has no ${method} with ${iterations} iterations`);
  return found;
}

const finest = ({ errors }: Errors) => errors[errors.length - 1].error;

describe('a spring on a line', () => {
  // The next term of the error is ωTΔtω/4 of the first: 5 % and less in the finest half.
  it.each(measured.line)('has order 1 by $way.method', (method) => {
    expect(slopeOf(method)).toBeGreaterThan(0.95);
    expect(slopeOf(method)).toBeLessThan(1.05);
  });

  it('has the largest part of the error that theory predicts', () => {
    const { spring, T } = experiments.line;
    const omega = Math.sqrt(spring.k / spring.m);
    const [amplitude, product] = [spring.start[0] - spring.r, (omega * T) / stepCounts[stepCounts.length - 1]];
    // Forward and implicit Euler change the amplitude by e^{±½ Δtω ωT}; symplectic Euler is half a step ahead.
    const damping = (amplitude * Math.abs(Math.cos(omega * T)) * product * omega * T) / 2;
    const delay = (amplitude * Math.abs(Math.sin(omega * T)) * product) / 2;
    expect(finest(of('line', { method: 'forward-euler', iterations: 1 })) / damping).toBeCloseTo(1, 1);
    expect(finest(of('line', newton)) / damping).toBeCloseTo(1, 1);
    expect(finest(of('line', { method: 'symplectic-euler', iterations: 1 })) / delay).toBeCloseTo(1, 1);
  });

  it('is taken to the same place by Newton’s method, linearly implicit Euler and a single iteration of local/global', () => {
    const { spring, T } = experiments.line;
    for (const steps of stepCounts) {
      const [x, y] = placeAfter(solver, spring, newton, T, steps);
      for (const way of [localGlobal(1), { method: 'linearly-implicit', iterations: 1 } as const]) {
        const [otherX, otherY] = placeAfter(solver, spring, way, T, steps);
        // The direction never turns, so d is right at once and E is a parabola. What is left is rounding: 1e-16 m a step, which the velocity carries
        // on, at random in either direction: 2048^1.5 times as much.
        expect(Math.abs(otherX - x)).toBeLessThan(1e-11);
        expect(otherY).toBe(y);
      }
    }
  });

  it('looks like a higher order where the first term of the error happens to be 0: after a quarter of a period, or a half', () => {
    const slopeAt = (way: Way, T: number) => {
      const { spring } = experiments.line;
      const exact = spring.r + (spring.start[0] - spring.r) * Math.cos(2 * Math.PI * T);
      return slopeOf({
        errors: stepCounts.map((steps) => ({
          delta_t: T / steps,
          error: Math.abs(placeAfter(solver, spring, way, T, steps)[0] - exact),
        })),
      });
    };
    expect(slopeAt({ method: 'forward-euler', iterations: 1 }, 1 / 4)).toBeCloseTo(2, 1);
    expect(slopeAt(newton, 1 / 4)).toBeCloseTo(2, 1);
    // x_n = x_0 cos((n + ½)φ) / cos ½φ with φ = Δtω + O(Δt³): at ωT = π the square is gone as well.
    expect(slopeAt({ method: 'symplectic-euler', iterations: 1 }, 1 / 2)).toBeCloseTo(3, 1);
  });
});

describe('a spring that swings', () => {
  it('is measured from a reference that twice as many steps leave alone', () => {
    const { spring, T } = experiments.swing;
    const coarser = reference(solver, spring, T, 4096);
    const finer = reference(solver, spring, T, 16384);
    const used = reference(solver, spring, T, 8192);
    // The text says 1e-9 m. The smallest error shown is above 2 mm.
    for (const other of [coarser, finer]) expect(Math.hypot(used[0] - other[0], used[1] - other[1])).toBeLessThan(1e-9);
  });

  it.each(measured.swing.filter(({ way }) => way.method !== 'local-global' || way.iterations > 2))(
    'has order 1 by $way.method with $way.iterations iterations',
    (method) => {
      expect(slopeOf(method)).toBeGreaterThan(0.95);
      expect(slopeOf(method)).toBeLessThan(1.05);
    },
  );

  it('is far from implicit Euler with one iteration, whose error vanishes with a slope that comes near 1', () => {
    const once = of('swing', localGlobal(1));
    const ratio = finest(once) / finest(of('swing', newton));
    expect(ratio).toBeGreaterThan(25);
    expect(ratio).toBeLessThan(35);
    const slopes = once.errors.slice(1).map(({ error }, at) => Math.log2(once.errors[at].error / error));
    for (const [at, slope] of slopes.slice(1).entries()) expect(slope).toBeGreaterThan(slopes[at]);
    expect(slopes[0]).toBeLessThan(0.3);
    expect(slopes[slopes.length - 1]).toBeGreaterThan(0.95);
    expect(slopes[slopes.length - 1]).toBeLessThan(1);
  });

  it('falls steeply onto implicit Euler with the second iteration: what is left vanishes at least with the square', () => {
    const { spring, T } = experiments.swing;
    const remainders = [512, 1024, 2048].map((steps) => {
      const [x, y] = placeAfter(solver, spring, newton, T, steps);
      const [otherX, otherY] = placeAfter(solver, spring, localGlobal(2), T, steps);
      return Math.hypot(x - otherX, y - otherY);
    });
    expect(remainders[0] / remainders[1]).toBeGreaterThan(4);
    expect(remainders[1] / remainders[2]).toBeGreaterThan(4);
  });

  it('needs more than ten iterations for the longest time step only', () => {
    const differences = of('swing', localGlobal(10)).errors.map(
      ({ error }, at) => Math.abs(error - of('swing', newton).errors[at].error) / error,
    );
    expect(differences[0]).toBeGreaterThan(0.01);
    for (const difference of differences.slice(1)) expect(difference).toBeLessThan(0.01);
  });

  it('is braked sideways by a single iteration, by 1 + Δt²k/m a step', () => {
    const { spring } = experiments.swing;
    const [delta_t, speed] = [0.02, 0.5];
    withOneSpring(solver, { ...spring, gravity: 0, start: [spring.r, 0] }, localGlobal(1), delta_t, (simulation) => {
      const p = Float64Array.of(0, 0, 0, spring.r, 0, 0);
      const p_prev = Float64Array.of(0, 0, 0, spring.r, -speed * delta_t, 0);
      simulation.set_state(1, p, p_prev, 0);
      simulation.step();
      // Positions of 1 m, rounded to 1e-16 m, over Δt.
      expect(simulation.velocity()[4]).toBeCloseTo(speed / (1 + (delta_t ** 2 * spring.k) / spring.m), 12);
    });
  });
});
