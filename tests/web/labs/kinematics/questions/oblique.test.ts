import { expect, it } from 'vitest';
import { boxAround, obliquePoints } from '../../../../../web/src/labs/kinematics/questions/oblique.ts';

it('up is up in the picture, and who is nearer stands lower on the floor', () => {
  const [origin, higher, nearer] = obliquePoints(Float64Array.of(0, 0, 0, 0, 1, 0, 0, 0, 1));
  expect(origin).toEqual([0, 0]);
  expect(higher[0]).toBeCloseTo(0, 14);
  expect(higher[1]).toBeLessThan(0);
  expect(nearer[1]).toBeGreaterThan(0);
});

it('all points are inside the box around them', () => {
  const cloud = Float64Array.of(1, 2, 3, -4, 0.5, 1, 0, -2, -3);
  const { x, y, width, height } = boxAround([cloud, Float64Array.of(0, 0, 0)]);
  for (const [right, down] of obliquePoints(cloud)) {
    expect(right).toBeGreaterThan(x);
    expect(right).toBeLessThan(x + width);
    expect(down).toBeGreaterThan(y);
    expect(down).toBeLessThan(y + height);
  }
});
