import { expect, it } from 'vitest';
import { boundsNear } from '../../../../web/src/views/scene3d/bounds_near.ts';

it('holds the points and the pointer, with 10 pixels around them', () => {
  expect(boundsNear(Float32Array.of(100, 100, 130, 90), 120, 96)).toEqual({ x: 90, y: 80, width: 50, height: 30 });
  expect(boundsNear(Float32Array.of(100, 100), 104, 100)).toEqual({ x: 90, y: 90, width: 24, height: 20 });
});

it('reaches 60 pixels from the pointer along a spring that is longer', () => {
  expect(boundsNear(Float32Array.of(0, 0, 1000, 0), 500, 2)).toEqual({ x: 430, y: -10, width: 140, height: 22 });
});
