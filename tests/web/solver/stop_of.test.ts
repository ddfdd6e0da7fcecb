import { describe, expect, it } from 'vitest';
import type { Minimiser } from '../../../web/src/solver/module.ts';
import type { MethodRun } from '../../../web/src/solver/protocol.ts';
import { stopOf } from '../../../web/src/solver/stop_of.ts';

/** E and ‖∂E/∂p‖ halve from 64 J and 64 N; what the decrease is compared with, 1 J at least, halves only from 1 J on. */
function halving(method: Minimiser, iterations: number, converged = false): MethodRun {
  const k = Array.from({ length: iterations + 1 }, (_, at) => at);
  return {
    method,
    converged,
    milliseconds: 1,
    change: Float64Array.from(k, (at) => 64 / 2 ** at - 64),
    gradient: Float64Array.from(k, (at) => 64 / 2 ** at),
    decrease: Float64Array.from(k, (at) => (at === 0 ? Number.NaN : Math.min(1, 64 / 2 ** at))),
  };
}

const rules = { iterations: 50, stop_gradient: 0, stop_decrease: 0 };

describe('stopOf', () => {
  it('counts', () => {
    expect(stopOf(halving('lbfgs', 100), rules)).toEqual({ iterations: 50, reason: 'iterations' });
  });

  it('watches the gradient, at the start too', () => {
    const run = halving('lbfgs', 100);
    expect(stopOf(run, { ...rules, stop_gradient: 8 })).toEqual({ iterations: 3, reason: 'gradient' });
    expect(stopOf(run, { ...rules, stop_gradient: 7.9 })).toEqual({ iterations: 4, reason: 'gradient' });
    expect(stopOf(run, { ...rules, stop_gradient: 64 })).toEqual({ iterations: 0, reason: 'gradient' });
    expect(stopOf(run, { ...rules, iterations: 2, stop_gradient: 8 })).toEqual({ iterations: 2, reason: 'iterations' });
  });

  it('watches the decrease', () => {
    const run = halving('lbfgs', 100);
    expect(stopOf(run, { ...rules, stop_decrease: 1 })).toEqual({ iterations: 1, reason: 'decrease' });
    expect(stopOf(run, { ...rules, stop_decrease: 0.25 })).toEqual({ iterations: 8, reason: 'decrease' });
  });

  it('ends where E falls no further, except local and global step that only count', () => {
    expect(stopOf(halving('lbfgs', 7, true), rules)).toEqual({ iterations: 7, reason: 'rounding' });
    expect(stopOf(halving('local-global', 7, true), rules)).toEqual({ iterations: 50, reason: 'iterations' });
    const watched = { ...rules, stop_gradient: 1e-9 };
    expect(stopOf(halving('local-global', 7, true), watched)).toEqual({ iterations: 7, reason: 'rounding' });
  });

  it('claims nothing beyond what was computed', () => {
    for (const method of ['lbfgs', 'local-global'] as const) expect(stopOf(halving(method, 49), rules)).toBeNull();
  });
});
