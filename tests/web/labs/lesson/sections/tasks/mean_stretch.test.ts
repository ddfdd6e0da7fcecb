import { expect, it } from 'vitest';
import { meanStretch } from '../../../../../../web/src/labs/lesson/sections/tasks/mean_stretch.ts';

it('weighs every spring by its rest length', () => {
  const p = new Float64Array([0, 0, 0, 3, 4, 0, 3, 4, 1]); // springs of 5 m and 1 m
  const E = new Int32Array([0, 1, 1, 2]);
  expect(meanStretch(p, E, new Float64Array([10, 2]))).toBe(0.5);
  expect(meanStretch(p, E, new Float64Array([5, 1]))).toBe(1);
});
