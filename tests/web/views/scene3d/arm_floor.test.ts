import { expect, it } from 'vitest';
import { floorRadius, gridPieces, gridStepOf, mostPieces } from '../../../../web/src/views/scene3d/arm_floor.ts';

/** m: the least and the longest arm that there is, and the lab's. */
const reaches = [0.01, 0.3, 1, 2.499, 2.6, 4.99, 25, 100];

it('has lines every half metre for the lab’s arm, and a number of them that suits any other', () => {
  expect(gridStepOf(2.6)).toBe(0.5);
  for (const reach of reaches) {
    const lines = reach / gridStepOf(reach);
    expect(lines).toBeGreaterThanOrEqual(5);
    expect(lines).toBeLessThan(12.5); // between two steps of 1, 2, 5 lies a factor of 2.5 at most
  }
});

it('fits what is allocated, wherever the root is', () => {
  for (const reach of reaches) {
    for (const x of [0, 0.37 * reach, 20]) expect(gridPieces(x, -x, reach).ends.length / 6).toBeLessThan(mostPieces);
  }
});

it('begins within the circle, and its axes come last', () => {
  const { ends, axes } = gridPieces(0, 0, 2.6);
  expect(axes).toBeGreaterThan(0);
  for (let at = 0; at < ends.length; at += 6) {
    expect(Math.hypot(ends[at], ends[at + 2])).toBeLessThanOrEqual(floorRadius(2.6));
    const onAxis = (ends[at] === 0 && ends[at + 3] === 0) || (ends[at + 2] === 0 && ends[at + 5] === 0);
    expect(onAxis).toBe(at / 6 >= ends.length / 6 - axes);
  }
});
