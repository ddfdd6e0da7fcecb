import fc from 'fast-check';
import { Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { angleBetween, largestLinkAngle, largestTurn } from '../../../web/src/solver/ik_turns.ts';

const component = fc.double({ min: -1, max: 1, noNaN: true });
const rotation = fc
  .tuple(component, component, component, component)
  .filter((q) => Math.hypot(...q) > 0.1)
  .map((q) => new Quaternion(...q).normalize());
const axis = fc
  .tuple(component, component, component)
  .filter((v) => Math.hypot(...v) > 0.1)
  .map((v) => new Vector3(...v).normalize());

describe('the angle between two rotations', () => {
  it('is by how much the one was turned to make the other, however little, and whatever the sign of the quaternion', () => {
    const turn = fc.double({ min: 1e-9, max: Math.PI, noNaN: true });
    fc.assert(
      fc.property(rotation, axis, turn, fc.boolean(), (from, about, angle, negated) => {
        const to = from.clone().multiply(new Quaternion().setFromAxisAngle(about, angle));
        const factor = negated ? -1 : 1;
        const between = angleBetween(
          from.toArray(),
          to.toArray().map((c) => factor * c),
        );
        expect(Math.abs(between - angle)).toBeLessThan(1e-14); // rounding, in the quaternions too
      }),
    );
  });

  it('of poses is the largest of their joints’', () => {
    const half = Math.SQRT1_2;
    const rest = [0, 0, 0, 1];
    const quarter = [half, 0, 0, half];
    expect(largestTurn(Float64Array.of(...rest, ...rest), Float64Array.of(...rest, ...quarter))).toBeCloseTo(
      Math.PI / 2,
      14,
    );
  });
});

it('links of two poses differ by the angle between their directions', () => {
  const [a, b] = [Float64Array.of(0, 0, 0, 0, -1, 0, 0, -3, 0), Float64Array.of(0, 0, 0, 0, -1, 0, 2, -1, 0)];
  expect(largestLinkAngle(a, b)).toBeCloseTo(Math.PI / 2, 14);
  expect(largestLinkAngle(a, a)).toBe(0);
});
