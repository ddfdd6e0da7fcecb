import type { Scene } from '../../web/src/scene/scene.ts';

/** m: 1e-7 of the diagonal of the bounding box. Leaves room for any order of summation: rounding makes about 1e-13 of it. */
export function positionsTolerance({ V }: Scene): number {
  const extent = [0, 1, 2].map((axis) => {
    const coordinates = V.filter((_, index) => index % 3 === axis);
    return coordinates.reduce((a, b) => Math.max(a, b)) - coordinates.reduce((a, b) => Math.min(a, b));
  });
  return 1e-7 * Math.hypot(...extent);
}
