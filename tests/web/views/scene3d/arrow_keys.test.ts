import { expect, it } from 'vitest';
import { moveOf } from '../../../../web/src/views/scene3d/arrow_keys.ts';

/** A diagonal of 5 m, seen from +x: there right is −z. */
const V = Float64Array.of(0, 0, 0, 3, 4, 0);
const camera = { position: [10, 0, 0], target: [0, 0, 0] } as const;
const move = (key: string, shiftKey = false) =>
  moveOf({ key, shiftKey }, V, { position: [...camera.position], target: [...camera.target] });

it('moves by 0.5 % of the diagonal as the reader sees it, with Shift by ten times as much', () => {
  // Products of a few numbers near 1: rounding leaves 15 digits.
  move('ArrowRight')?.forEach((value, axis) => {
    expect(value).toBeCloseTo([0, 0, -0.025][axis], 15);
  });
  move('ArrowDown', true)?.forEach((value, axis) => {
    expect(value).toBeCloseTo([0, -0.25, 0][axis], 15);
  });
});

it('other keys move nothing', () => {
  expect(move('Enter')).toBeNull();
});
