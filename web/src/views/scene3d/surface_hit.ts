import { type Ray, Vector3 } from 'three';

/** A place of a net. */
export interface Spot {
  /** Metres. */
  point: Vector3;
  /** The vertices of the triangle or spring that it lies on. */
  corners: readonly number[];
}

/** Where a ray first meets triangles (#F×3), seen from either side, of which the vertices are now at `points` (#V×3, metres). */
export function surfaceHit(ray: Ray, F: Uint32Array, points: Float64Array): Spot | null {
  const [a, b, c, met] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  let least = Number.POSITIVE_INFINITY;
  let hit: Spot | null = null;
  for (let at = 0; at < F.length; at += 3) {
    a.fromArray(points, 3 * F[at]);
    b.fromArray(points, 3 * F[at + 1]);
    c.fromArray(points, 3 * F[at + 2]);
    if (!ray.intersectTriangle(a, b, c, false, met)) continue;
    const distance = met.distanceToSquared(ray.origin);
    if (distance >= least) continue;
    least = distance;
    hit = { point: met.clone(), corners: [F[at], F[at + 1], F[at + 2]] };
  }
  return hit;
}
