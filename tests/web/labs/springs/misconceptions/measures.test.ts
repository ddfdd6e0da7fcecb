import { describe, expect, it } from 'vitest';
import {
  lowest,
  rangeAround,
  rangeOfStill,
  thinned,
  total,
} from '../../../../../web/src/labs/springs/misconceptions/measures.ts';

it('the lowest vertex is the one of the least y', () => {
  expect(lowest(Float64Array.of(-9, 2, -9, 0, -1, 5, 0, 3, 0))).toBe(-1);
});

it('the energy is the sum of its kinds', () => {
  expect(total({ kinetic: 1, springs: 20, external: -300 })).toBe(-279);
});

it('thinned points keep the first and then those that are far enough', () => {
  const points = [0, 1, 2, 3, 7, 8, 9, 10].map((step) => [step, 0] as const);
  expect(thinned(points, 3).map(([step]) => step)).toEqual([0, 3, 7, 10]);
});

describe('the range around a curve', () => {
  it('leaves its extent free above and below', () => {
    expect(
      rangeAround([
        [0, 1],
        [1, 3],
        [2, 2],
      ]),
    ).toEqual([-1, 5]);
  });

  it('is not empty where the curve is flat, and open where there is none', () => {
    expect(
      rangeAround([
        [0, 2],
        [1, 2],
      ]),
    ).toEqual([1, 3]);
    expect(rangeAround([[0, 2]])).toBeUndefined();
  });
});

describe('the range of curves that stand still', () => {
  const flat = [
    [0, -2],
    [1, -2 + 2 ** -30],
  ] as const;

  it('is two units wide', () => expect(rangeOfStill([flat, flat])).toEqual([-3, -1 + 2 ** -30]));

  it('is left to the chart where something moves, or nothing is there', () => {
    expect(rangeOfStill([flat, [[0, -1]]])).toBeUndefined();
    expect(rangeOfStill([[], []])).toBeUndefined();
  });
});
