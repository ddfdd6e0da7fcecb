import { beforeEach, describe, expect, it } from 'vitest';
import {
  compared,
  compareNewton,
  comparison,
  comparisonRequest,
  missingMethod,
  timeStep,
} from '../../../web/src/app/comparison.ts';
import { route, springsRoute } from '../../../web/src/app/route.ts';
import { defaultState, frame, state } from '../../../web/src/app/state.ts';
import type { Frame } from '../../../web/src/solver/frame.ts';
import type { Minimiser } from '../../../web/src/solver/module.ts';
import type { MethodRun, Outcome } from '../../../web/src/solver/protocol.ts';

const showing = (plot: 'trace' | 'comparison') => {
  state.value = { ...state.value, view: { ...state.value.view, plot } };
};
const setParameters = (parameters: (typeof state.value)['parameters']) => {
  state.value = { ...state.value, parameters };
};
const goTo = (step: number) => {
  frame.value = { step, events: [] } as unknown as Frame;
};

function finish(method: Minimiser): void {
  const run: Outcome<MethodRun> = {
    ok: true,
    value: {
      method,
      change: Float64Array.of(0),
      gradient: Float64Array.of(0),
      decrease: Float64Array.of(Number.NaN),
      converged: true,
      milliseconds: 1,
    },
  };
  compared(timeStep.value, method, run);
}

/** Runs every method that is missing; which they were. */
function finishAll(): Minimiser[] {
  const finished: Minimiser[] = [];
  for (let method = missingMethod.value; method; method = missingMethod.value) {
    finish(method);
    finished.push(method);
  }
  return finished;
}

beforeEach(() => {
  state.value = defaultState;
  route.value = springsRoute;
  comparison.value = null;
  goTo(1);
  showing('comparison');
});

describe('the comparison', () => {
  it('asks for nothing as long as it is not shown', () => {
    showing('trace');
    expect(missingMethod.value).toBeNull();
  });

  it('asks for one method after the other, Newton’s only when told to', () => {
    expect(finishAll()).toEqual(['lbfgs', 'local-global', 'chebyshev', 'anderson']);
    compareNewton();
    expect(finishAll()).toEqual(['newton']);
    expect(comparison.value?.runs).toHaveLength(5);
  });

  it('has Newton’s method without asking once that is the method chosen', () => {
    setParameters({ method: 'newton' });
    expect(finishAll()).toEqual(['lbfgs', 'local-global', 'chebyshev', 'anderson', 'newton']);
  });

  it('is made in the convergence room with Newton’s method, which takes no longer there than a click can wait', () => {
    showing('trace');
    goTo(7); // for which nobody has asked yet
    route.value = { page: 'springs', room: 'convergence' };
    expect(finishAll()).toEqual(['lbfgs', 'local-global', 'chebyshev', 'anderson', 'newton']);
    const unasked = comparisonRequest('newton').patience_ms;
    compareNewton();
    expect(comparisonRequest('newton').patience_ms).toBeGreaterThan(unasked);
  });

  it.each([
    { page: 'lesson', section: null },
    { page: 'springs', room: 'matrices' },
  ] as const)('is not made where it is not shown: %j', (elsewhere) => {
    route.value = elsewhere;
    expect(missingMethod.value).toBeNull();
  });

  it('is made anew for another time step, and Newton’s method asked for again', () => {
    compareNewton();
    finishAll();
    goTo(2);
    expect(finishAll()).toHaveLength(4);
    expect(comparison.value?.of.step).toBe(2);
  });

  it('is made anew for other parameters, not for another method or number of iterations', () => {
    finishAll();
    setParameters({ method: 'anderson', iterations: 7, stop_gradient: 1 });
    expect(missingMethod.value).toBeNull();
    setParameters({ k: 77 });
    expect(missingMethod.value).toBe('lbfgs');
  });

  it('is made anew after the page has gone on and come back, since p^t may be another', () => {
    finishAll();
    const asked = timeStep.value;
    goTo(2);
    void missingMethod.value; // as the session does
    goTo(1);
    expect(timeStep.value).not.toBe(asked);
    expect(missingMethod.value).toBe('lbfgs');
  });

  it('forgets what comes too late', () => {
    const asked = timeStep.value;
    goTo(2);
    compared(asked, 'lbfgs', { ok: false, status: { code: 'diverged', field: 'p', index: 0, value: 0, limit: 0 } });
    expect(comparison.value).toBeNull();
  });

  it('does not ask again for what was refused', () => {
    compared(timeStep.value, 'lbfgs', {
      ok: false,
      status: { code: 'too_large', field: 'H', index: -1, value: 1e9, limit: 1e8 },
    });
    expect(missingMethod.value).toBe('local-global');
    expect(comparison.value?.refusals.map(({ method }) => method)).toEqual(['lbfgs']);
  });
});
