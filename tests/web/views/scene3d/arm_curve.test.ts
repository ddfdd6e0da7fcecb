import { describe, expect, it } from 'vitest';
import { armCurveOf, penPairs, segmentsAt } from '../../../../web/src/views/scene3d/arm_curve.ts';

describe('a drawing on the floor', () => {
  it('joins neighbours of one stroke', () => {
    expect(penPairs([0, 0, 0, 1, 1])).toEqual([0, 1, 1, 2, 3, 4]);
    expect(penPairs([])).toEqual([]);
    expect(segmentsAt([0, 0, 0, 1, 1])).toEqual(Int32Array.of(0, 1, 2, 2, 3));
  });

  it('has the targets at which the pen is down, where the effector came to at them, and how many were gone to', () => {
    // Two joints: a root at the origin, and an effector whose x is ten times that of its target.
    const row = (x: number) => [x, 0, 0];
    const targets = Float64Array.from([1, 2, 3, 4].flatMap(row));
    const x = Float64Array.from([1, 2, 3, 4].flatMap((place) => [...row(0), ...row(10 * place)]));
    const followed = {
      x,
      q: new Float64Array(32),
      errors: new Float64Array(4),
      iterations: new Int32Array(4),
      outcomes: [],
    };
    const curve = armCurveOf({ targets, strokes: Int32Array.of(0, 0, -1, 1), followed });
    expect([...curve.targets]).toEqual([1, 2, 4].flatMap(row));
    expect([...curve.effector]).toEqual([10, 20, 40].flatMap(row));
    expect([...curve.stroke]).toEqual([0, 0, 1]);
    expect([...curve.gone]).toEqual([1, 2, 2, 3]);
  });
});
