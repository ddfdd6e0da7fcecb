import { describe, expect, it } from 'vitest';
import type { EnergySample } from '../../../../web/src/app/side_by_side_record.ts';
import { calmRange, energyRate, shownSamples } from '../../../../web/src/labs/integrators/energies.ts';

/** So many time steps of 10 ms. */
const samples = (steps: number, energy: (time: number) => number): EnergySample[] =>
  Array.from({ length: steps }, (_, at) => {
    const time = (at + 1) / 100;
    return { step: at + 1, time, stretch: 0, kinetic: energy(time), springs: 2, external: -1 };
  });

describe('the rate', () => {
  it('is the slope of a total that falls steadily', () => {
    // Hundred products of numbers of the order of 10: rounding is some 1e-13.
    expect(energyRate(samples(250, (time) => 10 - 3 * time))).toBeCloseTo(-3, 10);
  });

  it('is of the last second alone', () => {
    expect(energyRate(samples(300, (time) => (time <= 2 ? 50 * time : 100)))).toBeCloseTo(0, 10);
  });

  it('does not count what a change of method or motion has done', () => {
    const before = samples(50, () => 100);
    const after = samples(60, (time) => 10 - 3 * time).slice(50);
    const changed = after.map((sample) => ({ ...sample, stretch: 1 }));
    expect(energyRate([...before, ...changed])).toBeCloseTo(-3, 10);
  });

  it('is not told by less than three time steps', () => {
    expect(energyRate(samples(2, (time) => time))).toBeNull();
  });
});

describe('the samples shown', () => {
  it('are of the last ten seconds, and always the same time steps', () => {
    const before = shownSamples(samples(3000, () => 0));
    const after = shownSamples(samples(3001, () => 0));
    expect(before.length).toBeLessThanOrEqual(241);
    expect(before[0].time).toBeGreaterThan(20);
    const steps = new Set(before.map(({ step }) => step));
    // All but the newest, which is drawn wherever it is, and the oldest, which leaves.
    for (const { step } of after.slice(0, -1)) expect(steps).toContain(step);
  });
});

describe('the frame', () => {
  it('is left to the chart while nothing explodes', () => {
    expect(
      calmRange([
        [0, 1, 2],
        [0, -3, 5],
      ]),
    ).toBeUndefined();
  });

  it('is made for the others where one explodes', () => {
    expect(
      calmRange([
        [0, 1, 2],
        [0, 1e3, 1e9],
        [0, 0],
      ]),
    ).toEqual([-1, 3]);
  });
});
