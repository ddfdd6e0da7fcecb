import { expect, test } from 'vitest';
import { stabilityLimits, substepsBelow } from '../../../../web/src/labs/integrators/stability_limits.ts';
import type { Method } from '../../../../web/src/solver/module.ts';
import { openSimulation } from '../../../support/open_simulation.ts';
import { usualParameters } from '../../../support/small_scenes.ts';

/** The largest growth a step of x″ = −ω²x − 2ζω x′ with Δt·ω = s, ω = 1: the spectral radius of the method's 2×2 matrix. */
function growth(method: 'symplectic' | 'forward', s: number, zeta: number): number {
  // (x, v) ↦ (x + s v, v − s(x + 2ζ v)), and with the new velocity in x for symplectic Euler.
  const trace = 2 - 2 * zeta * s - (method === 'symplectic' ? s * s : 0);
  const determinant = 1 - 2 * zeta * s + (method === 'forward' ? s * s : 0);
  const discriminant = trace * trace - 4 * determinant;
  if (discriminant < 0) return Math.sqrt(determinant);
  return (Math.abs(trace) + Math.sqrt(discriminant)) / 2;
}

test.each([0.05, 0.5, 0.9, 1.5, 4])('a damped oscillation grows just beyond the limits, ζ = %f', (zeta) => {
  const limits = stabilityLimits(2 * zeta, 1, 1); // ζ = cω/2k
  for (const method of ['symplectic', 'forward'] as const) {
    // A thousandth beside the limit is far more than rounding.
    expect(growth(method, limits[method] * 1.001, zeta)).toBeGreaterThan(1);
    expect(growth(method, limits[method] * 0.999, zeta)).toBeLessThan(1);
  }
});

test('the core says the same of a spring between two masses', () => {
  const [k, damping] = [100, 3]; // N/m, N·s/m
  const omega = Math.sqrt(2 * k); // rad/s, for masses of 1 kg
  const limits = stabilityLimits(omega, damping, k);
  const pair = {
    V: Float64Array.of(0, 0, 0, 1, 0, 0),
    E: Int32Array.of(0, 1),
    m: Float64Array.of(1, 1),
    pinned: new Int32Array(),
  };
  const limitOf = (method: Method) =>
    openSimulation(pair, { ...usualParameters, path: 'fast', k, damping, method }).stability_limit();
  // The core finds ω by iteration, to half a percent at worst.
  expect(limitOf('symplectic-euler') / limits.symplectic).toBeCloseTo(1, 2);
  expect(limitOf('forward-euler') / limits.forward).toBeCloseTo(1, 2);
});

test('without damping symplectic Euler holds below 2, forward Euler never', () => {
  expect(stabilityLimits(30, 0, 100)).toEqual({ symplectic: 2, forward: 0 });
});

test('substeps are as few as stay below the limit, not on it', () => {
  expect([substepsBelow(2, 1.9), substepsBelow(2, 4), substepsBelow(2, 5.6)]).toEqual([1, 3, 3]);
});
