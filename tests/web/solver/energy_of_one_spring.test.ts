import { describe, expect, it } from 'vitest';
import { measuredLaw, perPeriod, predictedLaw } from '../../../web/src/labs/integrators/order/energy_laws.ts';
import { firstPlace, products, stabilityLimit } from '../../../web/src/labs/integrators/order/products.ts';
import { energyOfOneSpring, explodedRatio, shownPeriods } from '../../../web/src/solver/energy_of_one_spring.ts';
import { solver } from '../../support/open_simulation.ts';

const energies = energyOfOneSpring(solver, products);
const measured = products.map((product, at) => ({ product, ratios: energies[at] }));

/** Positions near 1 m are rounded by 1e-16 m, and the energy, at first that of 0.01 m, is quadratic in what is left of them. */
const rounding = (ratio: number) => 1e-12 / Math.sqrt(ratio);

describe.each(measured)('the energy with Δt·ω = $product', ({ product, ratios }) => {
  it('is multiplied by 1 + Δt²ω² in every step of forward Euler, and divided by it in every step of implicit Euler', () => {
    const gain = 1 + product ** 2;
    for (const [method, factor] of [
      ['forward-euler', gain],
      ['newton', 1 / gain],
    ] as const)
      for (const [at, ratio] of ratios[method].slice(1).entries())
        expect(Math.abs(ratio / ratios[method][at] / factor - 1)).toBeLessThan(rounding(Math.min(1, ratio)) * gain);
  });

  it('stays in the band of symplectic Euler below Δt·ω = 2, and is left to explode from there on', () => {
    const most = Math.max(...ratios['symplectic-euler']);
    const law = predictedLaw('symplectic-euler', product);
    if (law.kind !== 'band') throw new Error('symplectic Euler has a band');
    if (product < stabilityLimit) {
      expect(most).toBeLessThanOrEqual(law.most * (1 + 1e-9));
      expect(Math.min(...ratios['symplectic-euler'])).toBeGreaterThanOrEqual(law.least * (1 - 1e-9));
    } else {
      expect(law.most).toBe(Number.POSITIVE_INFINITY);
      expect(most).toBeGreaterThan(explodedRatio);
    }
  });

  it('is shown for all of the five periods, or until it explodes', () => {
    for (const method of ['forward-euler', 'symplectic-euler', 'newton'] as const) {
      const steps = ratios[method].length - 1;
      const over = ratios[method][steps] >= explodedRatio;
      expect(over || steps * product >= shownPeriods * 2 * Math.PI).toBe(true);
    }
  });
});

describe('the laws', () => {
  it('are told from the energies', () => {
    expect(measuredLaw('forward-euler', [1, 2, 4, 8])).toEqual({ kind: 'factor', factor: 2 });
    expect(measuredLaw('symplectic-euler', [1, 0.9, 1.2])).toEqual({ kind: 'band', least: 0.9, most: 1.2 });
  });

  it('are the same measured and predicted, in all digits shown, where the slider stands at first', () => {
    const { product, ratios } = measured[firstPlace];
    for (const method of ['forward-euler', 'newton'] as const) {
      const [seen, said] = [measuredLaw(method, ratios[method]), predictedLaw(method, product)];
      if (seen.kind !== 'factor' || said.kind !== 'factor') throw new Error('both are factors');
      expect(perPeriod(seen.factor, product)).toBeCloseTo(perPeriod(said.factor, product), 9);
    }
  });
});
