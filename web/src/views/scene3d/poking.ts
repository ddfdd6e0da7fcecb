import { type Ray, Vector3 } from 'three';
import { Neighbours, trianglesEdges } from './neighbours.ts';
import type { Grip } from './pull.ts';
import { diagonal } from './screen_axes.ts';
import { encloses } from './surface_geometry.ts';
import { type Spot, surfaceHit } from './surface_hit.ts';
import type { Scene3DModel } from './types.ts';
import { verticesAround } from './vertices_around.ts';

export interface PokeOptions {
  /** Metres: how far around the pointer vertices are taken hold of; null: a share of the scene's size. */
  radius: number | null;
  /** N/m: of the spring that pulls each. */
  stiffness: number;
}

/** Of the scene's diagonal. */
const radiusShare = 0.08;

/** Where the nets of one scene can be taken hold of. Points are #V×3, metres: where the vertices of a net are now. */
export class Poking {
  /** Whether there is a surface; only that can be touched then. */
  readonly hasSurface: boolean;
  /** Whether the surface hides what lies inside. */
  readonly solid: boolean;
  private readonly model: Pick<Scene3DModel, 'V' | 'E' | 'F'>;
  /** Along springs, inner ones too: what is pulled shall come as a whole. */
  private readonly joined: Neighbours;
  /** Along what is seen. */
  private readonly seen: Neighbours;
  private readonly usualRadius: number;

  constructor(model: Pick<Scene3DModel, 'V' | 'E' | 'F'>) {
    const { V, E, F } = model;
    this.model = model;
    this.hasSurface = F.length > 0;
    this.solid = encloses(F);
    this.joined = new Neighbours(E, V.length / 3);
    this.seen = this.hasSurface ? new Neighbours(trianglesEdges(F), V.length / 3) : this.joined;
    this.usualRadius = radiusShare * diagonal(V);
  }

  touched(ray: Ray, points: Float64Array): Spot | null {
    return surfaceHit(ray, this.model.F, points);
  }

  /** Whether the surface lies well in front of a point that is seen along a ray. */
  hides(point: Vector3, ray: Ray, points: Float64Array): boolean {
    const spot = this.solid ? this.touched(ray, points) : null;
    return spot !== null && spot.point.distanceTo(ray.origin) < point.distanceTo(ray.origin) - this.usualRadius / 2;
  }

  /** Of a spring, the point that is nearest to the ray. */
  onSpring(spring: number, ray: Ray, points: Float64Array): Spot {
    const corners = [...this.model.E.subarray(2 * spring, 2 * spring + 2)];
    const [a, b] = corners.map((v) => new Vector3().fromArray(points, 3 * v));
    const point = new Vector3();
    ray.distanceSqToSegment(a, b, undefined, point);
    return { point, corners };
  }

  onVertex(vertex: number, points: Float64Array): Spot {
    return { point: new Vector3().fromArray(points, 3 * vertex), corners: [vertex] };
  }

  /** Null where everything is fixed. */
  grip(spot: Spot, points: Float64Array, fixed: Int32Array, radius: number | null): Grip | null {
    const vertices = verticesAround(spot, points, this.joined, radius ?? this.usualRadius, new Set(fixed));
    if (vertices.length === 0) return null;
    const from = new Float64Array(3 * vertices.length);
    vertices.forEach((v, at) => {
      from.set(points.subarray(3 * v, 3 * v + 3), 3 * at);
    });
    return { vertices, from };
  }

  /** That can be seen. */
  neighboursOf(vertex: number): number[] {
    return [...new Set(this.seen.of(vertex))];
  }

  /** The highest vertex at rest that can be seen and is not fixed; null when there is none. */
  first(fixed: Int32Array): number | null {
    const { V } = this.model;
    const held = new Set(fixed);
    let highest: number | null = null;
    for (let v = 0; v < V.length / 3; v++) {
      if (held.has(v) || this.seen.of(v).length === 0) continue;
      if (highest === null || V[3 * v + 1] > V[3 * highest + 1]) highest = v;
    }
    return highest;
  }
}
