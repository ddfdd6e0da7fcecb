import { expect, it } from 'vitest';
import { treeLayout } from '../../../../../web/src/labs/springs/matrices/tree_layout.ts';

it('puts leaves side by side and parents in the middle', () => {
  // 4 is the root of 2 (with leaves 0 and 1) and of 3, a leaf.
  const { x, depth, leaves, roots, height } = treeLayout(Int32Array.of(2, 2, 4, 4, -1));
  expect([leaves, roots, height]).toEqual([3, 1, 3]);
  expect([...depth]).toEqual([2, 2, 1, 1, 0]);
  expect(x[4]).toBe((x[2] + x[3]) / 2);
  expect(x[2]).toBe((x[0] + x[1]) / 2);
  expect(new Set([x[0], x[1], x[3]])).toEqual(new Set([0, 1, 2]));
});

it('draws a queue as long as a large matrix', () => {
  const count = 20_000;
  const { leaves, height } = treeLayout(Int32Array.from({ length: count }, (_, c) => (c + 1 < count ? c + 1 : -1)));
  expect([leaves, height]).toEqual([1, count]);
});

it('knows forests', () => {
  const { roots, leaves, height } = treeLayout(Int32Array.of(-1, -1));
  expect([roots, leaves, height]).toEqual([2, 2, 1]);
});
