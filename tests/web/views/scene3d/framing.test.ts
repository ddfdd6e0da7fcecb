import { describe, expect, it } from 'vitest';
import { framingOfFall, framingOfNow } from '../../../../web/src/views/scene3d/framing.ts';

/** Rows of the points that are not in V. */
function added(V: Float64Array, pinned: number[]): number[][] {
  const { points } = framingOfFall(V, Int32Array.from(pinned));
  return Array.from({ length: (points.length - V.length) / 3 }, (_, row) => [
    ...points.subarray(V.length + 3 * row, V.length + 3 * row + 3),
  ]);
}

const lowest = (rows: number[][]) => Math.min(...rows.map(([, y]) => y));
const leftmost = (rows: number[][]) => Math.min(...rows.map(([x]) => x));

describe('framingOfFall', () => {
  const level = Float64Array.of(0, 0, 0, 1, 0, 0);

  it('a spring held at one end may hang straight down, or swing to the other side', () => {
    const rows = added(level, [0]);
    expect(rows).toContainEqual([0, -1, 0]);
    expect(leftmost(rows)).toBeCloseTo(-0.7, 12);
  });

  it('a chain falls as far below a pin that lies aside of it as below one at its end', () => {
    const chain = Float64Array.of(-2, 0, 0, -1, 0, 0, 0, 0, 0);
    expect(lowest(added(chain, [2]))).toBe(-2);
  });

  it('a flag falls about its pole, no lower than its upper corner can hang, and flies over to the other side', () => {
    // 4 m long and 3 m high: its lower corner is 5 m from the upper end of the pole, and 4 m from the lower one.
    const flag = Float64Array.of(0, 0, 0, 0, 3, 0, 4, 0, 0, 4, 3, 0);
    const rows = added(flag, [0, 1]);
    expect(lowest(rows)).toBe(-2);
    expect(leftmost(rows)).toBeCloseTo(-2.8, 12);
  });

  it('a level chain held at both ends sags by no more than it lies aside of them', () => {
    const rows = added(Float64Array.of(0, 0, 0, 1, 0, 0, 2, 0, 0), [0, 2]);
    expect(lowest(rows)).toBeLessThan(0);
    expect(lowest(rows)).toBeGreaterThanOrEqual(-1);
  });

  it('a mast on two pins keeps to itself', () => {
    const mast = Float64Array.of(-1, 0, 0, 1, 0, 0, 0, 5, 0);
    for (const [x, y] of added(mast, [0, 1])) {
      expect(Math.abs(x)).toBeLessThanOrEqual(1);
      expect(y).toBeGreaterThanOrEqual(0);
    }
  });

  it('nothing is added where nothing is held', () => {
    expect(added(level, [])).toEqual([]);
  });

  it('what lies flat is seen from higher above than what stands, and a chain from the front', () => {
    const polar = (V: number[]) => framingOfFall(Float64Array.from(V), Int32Array.of(0)).polar;
    const flat = [0, 0, 0, 1, 0, 0, 0, 0, 1];
    const standing = [0, 0, 0, 0, 1, 0];
    const chain = [0, 0, 0, 1, 0, 0, 2, 0, 0];
    expect(polar(flat)).toBeLessThan(polar(standing));
    expect(polar(chain)).toBe(polar(standing));
    expect(framingOfFall(Float64Array.from(chain), Int32Array.of(0)).azimuth).toBe(0);
  });
});

it('framingOfNow holds every vertex and every pin', () => {
  const { points } = framingOfNow(Float64Array.of(0, -9, 0, 1, -9, 0), Float64Array.of(5, 5, 5));
  expect([...points]).toEqual([0, -9, 0, 1, -9, 0, 5, 5, 5]);
});
