import { expect, test } from 'vitest';
import { changesBetween } from '../../../../../../web/src/labs/lesson/figures/changes.ts';
import { denseValues } from '../../../../../../web/src/labs/lesson/figures/dense_values.ts';
import { sumOf } from '../../../../../../web/src/labs/lesson/sections/matrices/terms_of_q.ts';
import { openSimulation } from '../../../../../support/open_simulation.ts';
import { net, usualParameters } from '../../../../../support/small_scenes.ts';

const simulation = () => openSimulation(net(3), { ...usualParameters, w: 1e4 });

test('the three terms add up to the solver’s Q', () => {
  const s = simulation();
  const Q = denseValues(s.Q());
  const sum = sumOf(['springs', 'masses', 'pins'], { A: s.A(), M: s.M(), C: s.C() }, { ...usualParameters, w: 1e4 });
  for (const [at, entry] of Q.entries()) expect(sum[at]).toBeCloseTo(entry, 9);
});

test('the springs alone are k times the graph’s Laplacian: degrees, −1 for neighbours, rows that add up to nothing', () => {
  const s = simulation();
  const k = 7;
  const laplacian = sumOf(['springs'], { A: s.A(), M: s.M(), C: s.C() }, { k, delta_t: 1, w: 1 });
  const { E } = net(3);
  for (let i = 0; i < 9; i++) {
    const row = laplacian.subarray(9 * i, 9 * i + 9);
    expect(row[i]).toBe(k * E.filter((end) => end === i).length);
    expect(row.reduce((sum, entry) => sum + entry, 0)).toBe(0);
  }
});

test('a change is any number that is not as it was', () => {
  const before = { p: Float64Array.of(1, 2), d: Float64Array.of(3), Q: Float64Array.of(4) };
  expect([...changesBetween(before, { ...before, p: Float64Array.of(1, 2.5), d: new Float64Array(0) })]).toEqual([
    'p',
    'd',
  ]);
});
