import { describe, expect, it } from 'vitest';
import { framingOf } from '../../../../web/src/views/scene3d/framing.ts';

/** Rows of the points that are not in V. */
function added(V: Float64Array, pinned: number[]): number[][] {
  const { points } = framingOf(V, Int32Array.from(pinned));
  return Array.from({ length: (points.length - V.length) / 3 }, (_, row) => [
    ...points.subarray(V.length + 3 * row, V.length + 3 * row + 3),
  ]);
}

describe('framingOf', () => {
  const level = Float64Array.of(0, 0, 0, 1, 0, 0);

  it('a spring held at one end may hang straight down, or swing to the other side', () => {
    expect(added(level, [0])).toEqual(
      expect.arrayContaining([
        [1, -1, 0],
        [-1, 0, 0],
      ]),
    );
  });

  it('a level chain held at both ends sags by no more than it lies aside of them', () => {
    const chain = Float64Array.of(0, 0, 0, 1, 0, 0, 2, 0, 0);
    const lowest = Math.min(...added(chain, [0, 2]).map(([, y]) => y));
    expect(lowest).toBeLessThan(0);
    expect(lowest).toBeGreaterThanOrEqual(-1);
  });

  it('what stands upright keeps to itself', () => {
    const mast = Float64Array.of(0, 0, 0, 0.1, 2, 0);
    for (const row of added(mast, [0, 1])) expect([...mast].join()).toContain(row.join());
  });

  it('nothing is added where nothing is held', () => {
    expect(added(level, [])).toEqual([]);
  });

  it('what lies flat is seen from higher above than what stands', () => {
    const standing = Float64Array.of(0, 0, 0, 0, 1, 0);
    expect(framingOf(level, Int32Array.of(0)).polar).toBeLessThan(framingOf(standing, Int32Array.of(0)).polar);
  });
});
