import { expect, it } from 'vitest';
import { neighbourTowards } from '../../../../web/src/views/scene3d/neighbour_towards.ts';

const here = { x: 10, y: 10 };
/** y grows downwards on the screen: 1 lies right, 2 right and a little up, 3 straight down, 4 in the same place. */
const places = new Map([
  [1, { x: 30, y: 10 }],
  [2, { x: 20, y: 4 }],
  [3, { x: 10, y: 20 }],
  [4, { x: 10, y: 10 }],
]);

it('goes to what lies best in a direction as the reader sees it', () => {
  expect(neighbourTowards(here, places, [1, 0])).toBe(1);
  expect(neighbourTowards(here, places, [0, -1])).toBe(3);
});

it('goes nowhere when nothing lies within 60° of it', () => {
  expect(neighbourTowards(here, places, [-1, 0])).toBeNull();
  expect(neighbourTowards(here, new Map([[2, { x: 20, y: 4 }]]), [0, 1])).toBe(2); // 59.04° from upright
  expect(neighbourTowards(here, new Map([[2, { x: 20, y: 5 }]]), [0, 1])).toBeNull(); // 63.4°
});
