import { expect, it } from 'vitest';
import { comparisonCsv } from '../../../../web/src/views/plots/comparison_csv.ts';

it('writes one line an iterate, in full precision', () => {
  const run = { method: 'lbfgs', milliseconds: 0.25, converged: true } as const;
  expect(
    comparisonCsv([
      {
        ...run,
        change: Float64Array.of(0, -1 / 3),
        gradient: Float64Array.of(2, 0.1),
        decrease: Float64Array.of(Number.NaN, 1 / 3),
      },
    ]),
  ).toBe('method,iteration,milliseconds,change,gradient\nlbfgs,0,0,0,2\nlbfgs,1,0.25,-0.3333333333333333,0.1\n');
});
