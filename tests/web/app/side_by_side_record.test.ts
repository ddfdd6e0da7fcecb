import { expect, test } from 'vitest';
import { SideBySideRecord } from '../../../web/src/app/side_by_side_record.ts';
import type { VariantState } from '../../../web/src/solver/side_by_side.ts';

const state = (x: number, steps: number): VariantState => ({
  p: Float64Array.of(x, 0, 0),
  energies: Array.from({ length: steps }, () => ({ kinetic: x, springs: 0, external: 0 })),
  milliseconds: 1,
  factorisations: 1,
  cost: null,
  failure: null,
});

test('every time step has its number and its time, also when Δt changes', () => {
  const record = new SideBySideRecord();
  record.begin(1);
  record.add([state(0, 2)], 2, 0.5, 0);
  record.add([state(0, 1)], 1, 0.25, 0);
  expect(record.energies[0].map(({ step, time }) => [step, time])).toEqual([
    [1, 0.5],
    [2, 1],
    [3, 1.25],
  ]);
});

test('samples say from when on methods and motions are what they are', () => {
  const record = new SideBySideRecord();
  record.begin(1);
  record.add([state(0, 1)], 1, 0.5, 0);
  record.reorder([0]);
  record.add([state(0, 1)], 1, 0.5, 0);
  record.interrupt();
  record.add([state(0, 1)], 1, 0.5, 0);
  expect(record.energies[0].map(({ stretch }) => stretch)).toEqual([0, 1, 2]);
});

test('only the latest are kept, however long it runs', () => {
  const record = new SideBySideRecord();
  record.begin(2);
  for (let request = 0; request < 100; request++) record.add([state(0, 50), state(3, 50)], 50, 0.01, 0);
  for (const curve of record.energies) {
    expect(curve).toHaveLength(2000);
    expect(curve.at(-1)?.step).toBe(5000);
  }
  expect(record.distances[1].at(-1)?.distance).toBe(3);
});
