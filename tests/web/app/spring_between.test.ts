import { expect, test } from 'vitest';
import { springBetween } from '../../../web/src/app/spring_between.ts';

test('the spring between two vertices is found from either end, the first of several, and nowhere else', () => {
  const E = Int32Array.of(0, 1, 2, 1, 1, 0);
  expect(springBetween(E, 0, 1)).toBe(0);
  expect(springBetween(E, 1, 0)).toBe(0);
  expect(springBetween(E, 1, 2)).toBe(1);
  expect(springBetween(E, 0, 2)).toBeNull();
  expect(springBetween(Int32Array.of(0, 2), 0, 2)).toBe(0); // another list has springs of its own
});
