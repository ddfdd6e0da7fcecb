import { describe, expect, it } from 'vitest';
import type { Minimiser } from '../../../../web/src/solver/module.ts';
import type { MethodRun } from '../../../../web/src/solver/protocol.ts';
import {
  abscissaRange,
  comparisonCurves,
  drawnPoints,
  firstPlace,
  gapLeft,
  heightOf,
  pointAt,
} from '../../../../web/src/views/plots/comparison_curves.ts';

function run(method: Minimiser, milliseconds: number, change: number[], converged = false): MethodRun {
  const decrease = change.map((value, k) => change[k - 1] - value);
  return {
    method,
    milliseconds,
    converged,
    change: Float64Array.from(change),
    gradient: Float64Array.from(change, (value) => 8 + value),
    decrease: Float64Array.from(decrease),
  };
}

// By hand: L-BFGS reaches the lowest E, −8 J, in iteration 3, and its next one changes nothing.
const plain = run('local-global', 0.5, [0, -4, -6, -7]);
const lbfgs = run('lbfgs', 2, [0, -6, -7, -8, -8], true);
const { curves, minimum } = comparisonCurves([lbfgs, plain], 1e-6);

describe('comparisonCurves', () => {
  it('measures every method against the lowest E of all', () => {
    expect(minimum).toEqual({ method: 'lbfgs', iteration: 3, converged: true });
    expect(curves[1].points.map(({ gap }) => gap)).toEqual([8, 4, 2, 1]);
    expect(curves[1].points.map(({ milliseconds }) => milliseconds)).toEqual([0, 0.5, 1, 1.5]);
  });

  it('credits E* to the fewest iterations among the minimisers that differ by rounding only', () => {
    const newton = run('newton', 9, [0, -7, -8 + 1e-13]);
    const noise = run('anderson', 1, [0, -5, -7, -7.5, -8 - 1e-13], true);
    expect(comparisonCurves([lbfgs, noise, newton], 0).minimum).toEqual({
      method: 'newton',
      iteration: 2,
      converged: true, // two others have seen that E falls no further
    });
    const lower = run('anderson', 1, [0, -5, -7, -7.5, -8.1]);
    expect(comparisonCurves([lbfgs, lower], 0).minimum).toEqual({ method: 'anderson', iteration: 4, converged: false });
  });

  it('ends a curve where nothing but rounding is left', () => {
    expect(curves[0].points.map(({ gap }) => gap)).toEqual([8, 2, 1, null, null]);
    expect(drawnPoints(curves[0], 'gap')).toHaveLength(4);
    const [noisy] = comparisonCurves([run('anderson', 1, [0, -1, -1 - 1e-7, -1 - 2e-7])], 1e-6).curves;
    expect(drawnPoints(noisy, 'gap').map(({ gap }) => gap)).toEqual([1 + 2e-7, null]);
    expect(drawnPoints(noisy, 'gradient')).toHaveLength(4);
  });
});

it('draws the gap or the gradient, and on a log axis neither where it is zero', () => {
  expect(curves[0].points.map((point) => heightOf(point, 'gradient'))).toEqual([8, 2, 1, null, null]);
  expect(curves[1].points.map((point) => heightOf(point, 'gap'))).toEqual([8, 4, 2, 1]);
});

describe('gapLeft', () => {
  it('is the share of the first gap that so many iterations leave', () => {
    expect([0, 1, 2, 3].map((k) => gapLeft(curves[1], k))).toEqual([1, 0.5, 0.25, 0.125]);
    expect(gapLeft(curves[0], 50)).toBe(0); // it has come to E*, and more iterations change nothing
  });

  it('is not known beyond what was computed, nor where there was no gap', () => {
    expect(gapLeft(curves[1], 4)).toBeNull();
    const [still] = comparisonCurves([run('newton', 1, [0, 0], true)], 1e-6).curves;
    expect(gapLeft(still, 1)).toBeNull();
  });
});

describe('reading off', () => {
  it('finds how far each method has come, after iterations or after time', () => {
    expect(curves.map((curve) => pointAt(curve, 'iterations', 2).gap)).toEqual([1, 2]);
    expect(curves.map((curve) => pointAt(curve, 'milliseconds', 1.2).iteration)).toEqual([0, 2]);
    expect(pointAt(curves[1], 'iterations', 50).iteration).toBe(3);
  });

  it('begins after the K iterations of a time step, or after local/global’s time for them', () => {
    expect(firstPlace(curves, 'iterations', 50)).toBe(50);
    expect(firstPlace(curves, 'milliseconds', 50)).toBe(25);
    expect(abscissaRange(curves, 'iterations', 50)).toEqual([0, 100]);
    expect(abscissaRange(curves, 'iterations', 200)).toEqual([0, firstPlace(curves, 'iterations', 200)]);
  });

  it('has an axis of whole decades for the time: 0.5 ms to 6 ms', () => {
    expect(abscissaRange(curves, 'milliseconds', 50)).toEqual([0.1, 10]);
  });
});
