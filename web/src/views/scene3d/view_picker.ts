import { type Plane, type Ray, Vector3 } from 'three';
import type { Rectangle } from '../../lib/rectangle.ts';
import { boundsNear } from './bounds_near.ts';
import type { OrbitCamera } from './orbit_camera.ts';
import { nearestPoint, nearestSegment, tolerancesFor } from './picking.ts';
import type { PokeOptions, Poking } from './poking.ts';
import { pointOnPlane, projectPoints, rayThrough, worldToClip } from './projection.ts';
import type { Grip } from './pull.ts';
import type { Spot } from './surface_hit.ts';
import type { Hit, Scene3DFrame } from './types.ts';

/** A view as it was last drawn, for pointers to find things in. */
export interface DrawnView {
  rectangle: Rectangle;
  /** #V×3, metres. */
  points: Float64Array;
  /** #E×6, metres: both ends of every spring. */
  springEnds(): Float32Array;
  frame: Pick<Scene3DFrame, 'pinned' | 'targets'>;
  /** CSS pixels of a typical spring. */
  springPixels: number;
  /** Null where only pins can be dragged. */
  poke: Poke | null;
}

export interface Poke extends PokeOptions {
  poking: Poking;
}

/** Where a net can be taken hold of, and what comes with it. */
interface Handhold {
  spot: Spot;
  grip: Grip;
}

/** Finds what lies in a view under a place of the canvas (CSS pixels). */
export class ViewPicker {
  private readonly orbitCamera: OrbitCamera;

  constructor(orbitCamera: OrbitCamera) {
    this.orbitCamera = orbitCamera;
  }

  /** Pins before vertices before springs. Things in front do not hide those behind. */
  pick(view: DrawnView, x: number, y: number, pointerType: string): Hit | null {
    return this.pickPin(view, x, y, pointerType) ?? this.pickFree(view, x, y, pointerType);
  }

  pickPin(view: DrawnView, x: number, y: number, pointerType: string): Hit | null {
    const tolerance = tolerancesFor(pointerType, view.springPixels);
    const pin = nearestPoint(this.onScreen(view, view.frame.targets), x, y, tolerance.pin);
    if (pin === null) return null;
    const held = new Vector3().fromArray(view.frame.targets, 3 * pin);
    if (view.poke?.poking.hides(held, this.rayThrough(view, x, y), view.points)) return null;
    return { kind: 'vertex', index: view.frame.pinned[pin], bounds: boundsNear(Float32Array.of(x, y), x, y) };
  }

  /** On the surface if the net has one, else on what is seen of its vertices and springs. */
  handhold(view: DrawnView, x: number, y: number, pointerType: string): Handhold | null {
    const { poke, points, frame } = view;
    if (!poke) return null;
    const { poking, radius } = poke;
    const spot = poking.hasSurface
      ? poking.touched(this.rayThrough(view, x, y), points)
      : this.spotOf(view, x, y, pointerType, poking);
    const grip = spot && poking.grip(spot, points, frame.pinned, radius);
    return grip && { spot, grip };
  }

  /** Null when the plane is not under the place. */
  pointOn(plane: Plane, view: DrawnView, x: number, y: number): Vector3 | null {
    this.orbitCamera.setAspect(view.rectangle.width / view.rectangle.height);
    return pointOnPlane(this.orbitCamera.camera, view.rectangle, x, y, plane);
  }

  private pickFree(view: DrawnView, x: number, y: number, pointerType: string): Hit | null {
    const hit = (kind: Hit['kind'], index: number, drawn: Float32Array): Hit => {
      return { kind, index, bounds: boundsNear(drawn, x, y) };
    };
    const tolerance = tolerancesFor(pointerType, view.springPixels);
    const points = this.onScreen(view, view.points);
    const vertex = nearestPoint(points, x, y, tolerance.vertex);
    if (vertex !== null) return hit('vertex', vertex, points.subarray(2 * vertex, 2 * vertex + 2));
    const ends = this.onScreen(view, view.springEnds());
    const spring = nearestSegment(ends, x, y, tolerance.spring);
    return spring === null ? null : hit('spring', spring, ends.subarray(4 * spring, 4 * spring + 4));
  }

  private spotOf(view: DrawnView, x: number, y: number, pointerType: string, poking: Poking): Spot | null {
    const hit = this.pickFree(view, x, y, pointerType);
    if (!hit) return null;
    if (hit.kind === 'vertex') return poking.onVertex(hit.index, view.points);
    return poking.onSpring(hit.index, this.rayThrough(view, x, y), view.points);
  }

  private onScreen(view: DrawnView, points: Float64Array | Float32Array): Float32Array {
    this.orbitCamera.setAspect(view.rectangle.width / view.rectangle.height);
    return projectPoints(points, worldToClip(this.orbitCamera.camera), view.rectangle);
  }

  private rayThrough(view: DrawnView, x: number, y: number): Ray {
    this.orbitCamera.setAspect(view.rectangle.width / view.rectangle.height);
    return rayThrough(this.orbitCamera.camera, view.rectangle, x, y);
  }
}
