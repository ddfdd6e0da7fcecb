import { Quaternion as Reference, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import {
  axisAngle,
  conjugate,
  multiply,
  type Quaternion,
  rotate,
  rotationVector,
} from '../../../web/src/lib/quaternion.ts';

const a = new Reference(0.1, -0.7, 0.3, 0.2).normalize();
const b = new Reference(-0.4, 0.2, 0.9, -0.5).normalize();
const ours = (q: Reference): Quaternion => [q.x, q.y, q.z, q.w];

/** A few roundings of numbers up to 1. */
const digits = 14;

const close = (found: readonly number[], wanted: readonly number[]) => {
  for (const [at, value] of wanted.entries()) expect(found[at]).toBeCloseTo(value, digits);
};

describe('quaternions', () => {
  it('multiply and turn vectors as those of three.js do', () => {
    close(multiply(ours(a), ours(b)), ours(a.clone().multiply(b)));
    close(rotate(ours(a), [1, 2, 3]), new Vector3(1, 2, 3).applyQuaternion(a).toArray());
  });

  it('turn there and back by nothing', () => {
    close(multiply(ours(a), conjugate(ours(a))), [0, 0, 0, 1]);
    expect(axisAngle([0, 0, 0, 1])).toEqual({ axis: null, angle: 0 });
    expect(rotationVector([0, 0, 0, -1])).toEqual([0, 0, 0]);
  });

  it('have an axis and an angle of the shorter way, whatever their sign', () => {
    const angle = 0.3;
    const q = new Reference().setFromAxisAngle(new Vector3(0, 0.6, 0.8), angle);
    for (const sign of [1, -1]) {
      const turned = axisAngle(ours(q).map((part) => sign * part) as unknown as Quaternion);
      expect(turned.angle).toBeCloseTo(angle, digits);
      close(turned.axis ?? [], [0, 0.6, 0.8]);
    }
    close(rotationVector(ours(q)), [0, 0.6 * angle, 0.8 * angle]);
  });

  it('keep the digits of small angles', () => {
    expect(axisAngle([0, 0, 5e-13, 1]).angle / 1e-12).toBeCloseTo(1, digits);
  });
});
