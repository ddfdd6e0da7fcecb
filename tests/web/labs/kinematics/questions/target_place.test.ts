import fc from 'fast-check';
import { expect, it } from 'vitest';
import {
  angleBeside,
  placeBeside,
  placeOf,
  pointOf,
} from '../../../../../web/src/labs/kinematics/questions/target_place.ts';

it('a target straight down, to the right, and up, seen from the root', () => {
  const root = [0, 1.7, 0] as const;
  for (const [direction, point] of [
    [0, [0, -0.3, 0]],
    [90, [2, 1.7, 0]],
    [180, [0, 3.7, 0]],
  ] as const)
    pointOf({ distance: 2, direction }, root).forEach((coordinate, axis) => {
      expect(coordinate).toBeCloseTo(point[axis], 12);
    });
});

it('the target beside lies a centimetre further on the circle around the root', () => {
  const place = { distance: 2.5, direction: 30 };
  const [a, b] = [pointOf(place, [0, 0, 0]), pointOf(placeBeside(place), [0, 0, 0])];
  const chord = Math.hypot(b[0] - a[0], b[1] - a[1]);
  expect(chord).toBeCloseTo(0.01, 7); // an arc of 0.01 m is longer than its chord by 7e-9 m
  expect(angleBeside(place)).toBeCloseTo(0.2292, 4); // 0.01/2.5 rad
});

it('a dragged target is put where the pointer is, to centimetres and degrees', () => {
  fc.assert(
    fc.property(fc.integer({ min: 5, max: 500 }), fc.integer({ min: -179, max: 180 }), (centimetres, direction) => {
      const [right, up] = pointOf({ distance: centimetres / 100, direction }, [0, 0, 0]);
      expect(placeOf(right, up)).toEqual({ distance: centimetres / 100, direction });
    }),
  );
});
