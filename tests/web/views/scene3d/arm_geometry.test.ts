import { describe, expect, it } from 'vitest';
import { onFloor } from '../../../../web/src/app/kinematics_drawing.ts';
import {
  arcBetween,
  circleOnFloor,
  distanceOf,
  offFloor,
  reachOnFloor,
  rounded,
} from '../../../../web/src/views/scene3d/arm_geometry.ts';

const links = (...lengths: number[]) => lengths.map((length) => ({ length, bend: null }));
/** Of numbers about 1 that a few roundings have gone through. */
const rounding = 14; // decimals

describe('the floor', () => {
  it('is the curve’s plane seen from above', () => {
    expect(offFloor(onFloor([0.3, -0.2]))).toEqual([0.3, -0.2]);
    expect(offFloor([0.3, 1.5, -0.2])).toEqual([0.3, 0.2]);
  });

  it('cuts the reach of the lab’s arm in a circle by Pythagoras, and has no hole', () => {
    const { outer, inner } = reachOnFloor(links(0.8, 0.4, 0.2, 1.2), 1.7);
    expect(outer).toBeCloseTo(Math.sqrt(2.6 ** 2 - 1.7 ** 2), rounding);
    expect(inner).toBeNull();
  });

  it('is out of reach from high above; a link longer than all others leaves a hole around a root on the floor', () => {
    expect(reachOnFloor(links(0.5, 0.5), 1.2).outer).toBeNull();
    const { outer, inner } = reachOnFloor(links(0.25, 2, 0.5), 0);
    expect(outer).toBe(2.75);
    expect(inner).toBe(1.25);
  });

  it('carries circles, closed and all of one radius', () => {
    const points = circleOnFloor(0.5, -1, 2, 8);
    expect(points).toHaveLength(27);
    for (let i = 0; i <= 8; i++) {
      expect(points[3 * i + 1]).toBe(0);
      expect(distanceOf(points.subarray(3 * i, 3 * i + 3), [0.5, 0, -1])).toBeCloseTo(2, rounding);
    }
    expect(points[24]).toBeCloseTo(points[0], rounding);
    expect(points[26]).toBeCloseTo(points[2], rounding);
  });
});

describe('arcBetween', () => {
  const centre = [1, 2, 3];

  it('goes from one direction to the other at one distance, the short way and in equal turns', () => {
    const arc = arcBetween(centre, [3, 2, 3], [1, 2, 3.5], 0.5, 4);
    expect([...arc.subarray(0, 3)]).toEqual([1.5, 2, 3]);
    const end = arc.subarray(-3);
    for (const axis of [0, 1, 2]) expect(end[axis]).toBeCloseTo([1, 2, 3.5][axis], rounding);
    const step = distanceOf(arc.subarray(0, 3), arc.subarray(3, 6));
    expect(step).toBeCloseTo(2 * 0.5 * Math.sin(Math.PI / 16), rounding); // the chord of a quarter's quarter
    for (let i = 0; i < 4; i++) {
      expect(distanceOf(arc.subarray(3 * i, 3 * i + 3), centre)).toBeCloseTo(0.5, rounding);
      expect(distanceOf(arc.subarray(3 * i, 3 * i + 3), arc.subarray(3 * i + 3, 3 * i + 6))).toBeCloseTo(
        step,
        rounding,
      );
    }
  });

  it('is a point where nothing turns, half a circle where the directions are opposite, and never NaN', () => {
    const still = arcBetween(centre, [1, 2, 4], [1, 2, 7], 0.5, 3);
    for (let i = 0; i < 4; i++) expect([...still.subarray(3 * i, 3 * i + 3)]).toEqual([1, 2, 3.5]);
    const half = arcBetween(centre, [2, 2, 3], [0, 2, 3], 1, 2);
    expect(half[3]).toBeCloseTo(1, rounding); // at half time above or below the centre, whichever way
    expect(half[6]).toBeCloseTo(0, rounding);
    expect(arcBetween(centre, centre, [1, 1, 3], 1, 2).every(Number.isFinite)).toBe(true);
  });
});

describe('rounded', () => {
  it('keeps a tenth of a millimetre, stays where the state allows, and knows no negative zero', () => {
    expect(rounded([0.12345, -0.00001, 55])).toEqual([0.1235, 0, 20]);
    expect(rounded(Float64Array.of(-1e9, -20, 1))).toEqual([-20, -20, 1]);
  });
});
