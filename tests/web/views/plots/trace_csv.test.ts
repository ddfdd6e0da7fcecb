import { expect, it } from 'vitest';
import { traceCsv } from '../../../../web/src/views/plots/trace_csv.ts';

it('writes one line a half-step, every digit of every number, and nothing where there is none', () => {
  const third = 1 / 3;
  const terms = {
    objective: third,
    surrogate: third,
    potential: third,
    inertia: 0,
    external: 0,
    pin: 0,
    gradient: 0.1,
  };
  const csv = traceCsv([
    { half_step: 1, iteration: 1, phase: 'local', ...terms, residual: Number.NaN, change: 0 },
    { half_step: 2, iteration: 1, phase: 'global', ...terms, residual: 2e-12, change: third },
  ]);
  expect(csv).toBe(
    'half_step,iteration,phase,surrogate,objective,potential,inertia,external,pin,gradient,residual,change\n' +
      '1,1,local,0.3333333333333333,0.3333333333333333,0.3333333333333333,0,0,0,0.1,,0\n' +
      '2,1,global,0.3333333333333333,0.3333333333333333,0.3333333333333333,0,0,0,0.1,2e-12,0.3333333333333333\n',
  );
});
