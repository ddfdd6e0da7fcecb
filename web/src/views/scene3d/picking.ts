/** CSS pixels within which a pointer takes hold of something. */
export interface Tolerances {
  pin: number;
  vertex: number;
  spring: number;
}

/** Fingers are thicker than mouse pointers; and where vertices crowd, they must leave some room to their springs. */
export function tolerancesFor(pointerType: string, springPixels: number): Tolerances {
  const reach = pointerType === 'mouse' ? 1 : 2;
  return { pin: 12 * reach, vertex: Math.max(3, Math.min(10 * reach, 0.3 * springPixels)), spring: 6 * reach };
}

/** Index of the point (#×2, CSS pixels) nearest to (x, y) and within the tolerance, or null. */
export function nearestPoint(points: Float32Array, x: number, y: number, tolerance: number): number | null {
  return nearest(points.length / 2, tolerance, (v) => (points[2 * v] - x) ** 2 + (points[2 * v + 1] - y) ** 2);
}

/** Index of the segment (#×4, CSS pixels: two ends) nearest to (x, y) and within the tolerance, or null. */
export function nearestSegment(ends: Float32Array, x: number, y: number, tolerance: number): number | null {
  return nearest(ends.length / 4, tolerance, (s) => {
    const ux = ends[4 * s + 2] - ends[4 * s];
    const uy = ends[4 * s + 3] - ends[4 * s + 1];
    const px = x - ends[4 * s];
    const py = y - ends[4 * s + 1];
    const length2 = ux * ux + uy * uy;
    const t = length2 > 0 ? Math.max(0, Math.min(1, (px * ux + py * uy) / length2)) : 0;
    return (px - t * ux) ** 2 + (py - t * uy) ** 2;
  });
}

function nearest(count: number, tolerance: number, distance2: (index: number) => number): number | null {
  let best: number | null = null;
  let least = tolerance ** 2;
  for (let index = 0; index < count; index++) {
    const candidate = distance2(index);
    if (candidate <= least) {
      least = candidate;
      best = index;
    }
  }
  return best;
}
