import { expect, it } from 'vitest';
import { fullFraming, homeFraming } from '../../../../web/src/views/scene3d/arm_framing.ts';
import type { ArmPicture } from '../../../../web/src/views/scene3d/arm_picture.ts';

const picture = (target: readonly number[], targets: number[] = []) =>
  ({
    x: Float64Array.of(0, 1, 0, 0, 0.2, 0),
    root: [0, 1, 0],
    links: [{ length: 0.8, bend: null }],
    target,
    curve: targets.length > 0 ? { targets: Float64Array.from(targets) } : null,
  }) as unknown as ArmPicture;

const holds = (points: Float64Array, [x, y, z]: readonly number[]) =>
  Array.from({ length: points.length / 3 }, (_, i) => points.subarray(3 * i, 3 * i + 3)).some(
    (point) => point[0] === x && point[1] === y && point[2] === z,
  );

it('begins with the arm and its curve, and with a target only where that is not far off', () => {
  const near = [0.5, 0.5, 0];
  const far = [9, 0, 0];
  expect(holds(homeFraming(picture(near)).points, near)).toBe(true);
  expect(holds(homeFraming(picture(far)).points, far)).toBe(false);
  expect(holds(homeFraming(picture(far)).points, [0, 0.2, 0])).toBe(true);
  expect(holds(homeFraming(picture(near, [0.1, 0, 0.7])).points, [0.1, 0, 0.7])).toBe(true);
});

it('shows everything when it is asked to', () => {
  expect(holds(fullFraming(picture([9, 0, 0])).points, [9, 0, 0])).toBe(true);
});
