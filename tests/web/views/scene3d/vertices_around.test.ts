import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { Neighbours } from '../../../../web/src/views/scene3d/neighbours.ts';
import { verticesAround } from '../../../../web/src/views/scene3d/vertices_around.ts';

/** Two ears 0.1 m apart, which a head joins 3 m below their tips: 0–1–2–3 down the left one, 4–5–6–7 up the right one. */
const points = Float64Array.from(
  [3, 2, 1, 0].flatMap((y) => [0, y, 0]).concat([0, 1, 2, 3].flatMap((y) => [0.1, y, 0])),
);
const neighbours = new Neighbours([0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7], 8);
const none = new Set<number>();
const around = (y: number, corners: number[], radius: number, fixed = none) => [
  ...verticesAround({ point: new Vector3(0, y, 0), corners }, points, neighbours, radius, fixed),
];

describe('verticesAround', () => {
  it('takes all within the radius, the nearest first, and of one ear nothing from the other', () => {
    expect(around(2.9, [0, 1], 1.5)).toEqual([0, 1]);
    expect(around(2.1, [0, 1], 1.5)).toEqual([1, 0, 2]);
  });

  it('takes from both where they are joined within the radius', () => {
    expect(around(0, [3], 1.2).sort()).toEqual([2, 3, 4, 5]);
  });

  it('leaves out what is fixed, and goes on behind it', () => {
    expect(around(3, [0], 2.5, new Set([1]))).toEqual([0, 2]);
  });

  it('takes at least the nearest corner that is not fixed', () => {
    expect(around(2.4, [0, 1], 0.1)).toEqual([1]);
    expect(around(2.4, [0, 1], 0.1, new Set([1]))).toEqual([0]);
    expect(around(2.4, [0, 1], 0.1, new Set([0, 1]))).toEqual([]);
  });
});
