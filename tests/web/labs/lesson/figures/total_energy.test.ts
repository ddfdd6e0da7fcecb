import { expect, it } from 'vitest';
import { totalEnergy } from '../../../../../web/src/labs/lesson/figures/total_energy.ts';

it('adds ½ m v² of every mass to the energies of springs and gravity', () => {
  const evaluations = [
    { objective: 0, potential: 5, inertia: 100, external: -7, pin: 100, gradient: new Float64Array(6) },
  ];
  const before = new Float64Array(6);
  const now = Float64Array.of(1, 0, 0, 0, 2, 1); // in ½ s: v = (2, 0, 0) and (0, 4, 2) m/s
  const m = Float64Array.of(1, 3);
  expect(totalEnergy({ m, evaluations }, { time: 0, delta_t: 0.5, now, before })).toBe(5 - 7 + 2 + 30);
});
