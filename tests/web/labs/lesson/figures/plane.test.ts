import { describe, expect, it } from 'vitest';
import { Plane } from '../../../../../web/src/labs/lesson/figures/plane.ts';

// 4 m by 2 m on 400 px: 100 px/m
const plane = new Plane({ left: -1, right: 3, bottom: -1.5, top: 0.5 }, 400);

describe('Plane', () => {
  it('is as high as its width makes it', () => {
    expect(plane.height).toBe(200);
  });

  it('draws x to the right and y upwards', () => {
    expect(plane.place([0, 0, 0, 1, -1, 5], 1)).toEqual([200, 150]);
    expect(plane.length(0.25)).toBe(25);
  });

  it('finds the point, at z = 0, that is drawn at a place', () => {
    expect(plane.point([200, 150])).toEqual([1, -1, 0]);
  });
});
