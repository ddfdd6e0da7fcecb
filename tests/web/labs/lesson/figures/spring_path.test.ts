import { describe, expect, it } from 'vitest';
import { springPath } from '../../../../../web/src/labs/lesson/figures/spring_path.ts';

const corners = (path: string) =>
  path
    .slice(1)
    .split('L')
    .map((corner) => corner.split(' ').map(Number));

describe('springPath', () => {
  it('runs from end to end, to both sides of the straight line equally', () => {
    const path = corners(springPath([0, 0], [100, 0], 100));
    expect(path[0]).toEqual([0, 0]);
    expect(path.at(-1)).toEqual([100, 0]);
    expect(path.reduce((sum, [, y]) => sum + y, 0)).toBe(0);
  });

  it('keeps its coils when it is stretched', () => {
    const atRest = corners(springPath([0, 0], [100, 0], 100));
    const stretched = corners(springPath([0, 0], [0, 250], 100));
    expect(stretched).toHaveLength(atRest.length);
  });

  it('is a line, and no NaN, where both ends meet', () => {
    expect(springPath([3, 4], [3, 4], 50)).toBe('M3 4L3 4');
  });
});
