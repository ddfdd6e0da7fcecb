import { expect, test } from 'vitest';
import { drawingTargets } from '../../../web/src/app/kinematics_drawing.ts';
import type { Curve } from '../../../web/src/curves/curve.ts';

/** So many strokes, of which only this is asked. */
function curveOf(...closed: boolean[]): Curve {
  return { strokes: closed.map((one) => ({ from: 0, to: 1, at: () => [0, 0], corners: [], closed: one })) };
}

test('curves lie on the floor, and the pen is lifted between their strokes, no faster than it draws', () => {
  const sampled = {
    points: Float64Array.of(0, 0, 0.1, 0, 0.2, 0, 0.2, 0.3, 0.3, 0.3),
    stroke: Int32Array.of(0, 0, 0, 1, 1),
    t: Float64Array.of(0, 0.5, 1, 0, 1),
  };
  const { targets, strokes } = drawingTargets(curveOf(false, false), sampled);
  // 0.3 m between the strokes, at 0.1 m a target: two places between.
  expect([...strokes]).toEqual([0, 0, 0, -1, -1, 1, 1]);
  const rows = Array.from(strokes, (_, i) => [...targets.subarray(3 * i, 3 * i + 3)]);
  expect(rows[2]).toEqual([0.2, 0, -0]);
  expect(rows[5]).toEqual([0.2, 0, -0.3]);
  const height = 0.1 * Math.sin(Math.PI / 3); // m, after a third of the way and before the last
  [
    [0.2, height, -0.1],
    [0.2, height, -0.2],
  ].forEach((place, k) => {
    place.forEach((value, axis) => {
      expect(rows[3 + k][axis]).toBeCloseTo(value, 12);
    });
  });
});

test('strokes that meet need no way through the air', () => {
  const sampled = {
    points: Float64Array.of(0, 0, 0.1, 0, 0.1, 0, 0.1, 0.1),
    stroke: Int32Array.of(0, 0, 1, 1),
    t: Float64Array.of(0, 1, 0, 1),
  };
  expect([...drawingTargets(curveOf(false, false), sampled).strokes]).toEqual([0, 0, 1, 1]);
});

test('a closed stroke ends where it began', () => {
  const sampled = {
    points: Float64Array.of(0, 0, 0.1, 0, 0, 0.1),
    stroke: Int32Array.of(0, 0, 0),
    t: Float64Array.of(0, 1, 2),
  };
  const { targets, strokes } = drawingTargets(curveOf(true), sampled);
  expect(strokes).toHaveLength(4);
  expect([...targets.slice(9)]).toEqual([...targets.slice(0, 3)]);
});
