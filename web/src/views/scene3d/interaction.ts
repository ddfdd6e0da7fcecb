import { type Plane, Vector3 } from 'three';
import { Gestures } from '../../lib/gestures.ts';
import type { Rectangle } from '../../lib/rectangle.ts';
import { boundsNear } from './bounds_near.ts';
import type { OrbitCamera } from './orbit_camera.ts';
import { nearestPoint, nearestSegment, tolerancesFor } from './picking.ts';
import { facingPlane, pointOnPlane, projectPoints, worldToClip } from './projection.ts';
import type { CanvasCallbacks, Hit, Scene3DFrame } from './types.ts';

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
}

/** Radians that a pointer turns the camera by crossing the height of the canvas. */
const turnPerView = 5;

interface Held {
  vertex: number;
  view: DrawnView;
  plane: Plane;
  /** Metres from where the pointer meets the plane to the pin, so that the pin does not jump to the pointer. */
  grip: Vector3;
  moved: boolean;
}

/** Pointers on the canvas: they look at things, select them, drag pins, and otherwise move the camera. */
export class Interaction {
  hovered: Hit | null = null;
  private readonly canvas: HTMLCanvasElement;
  private readonly orbitCamera: OrbitCamera;
  private readonly viewAt: (x: number, y: number) => DrawnView | null;
  private readonly callbacks: CanvasCallbacks;
  private held: Held | null = null;
  private readonly gestures: Gestures;

  constructor(
    canvas: HTMLCanvasElement,
    orbitCamera: OrbitCamera,
    viewAt: (x: number, y: number) => DrawnView | null,
    callbacks: CanvasCallbacks,
  ) {
    this.canvas = canvas;
    this.orbitCamera = orbitCamera;
    this.viewAt = viewAt;
    this.callbacks = callbacks;
    this.gestures = new Gestures(canvas, {
      grab: (x, y, pointerType) => this.grab(x, y, pointerType),
      drag: (x, y) => this.drag(x, y),
      release: () => this.release(),
      tap: (x, y, pointerType, shift) => this.tap(x, y, pointerType, shift),
      hover: (place) => this.hover(place),
      orbit: (dx, dy) => {
        const turn = -turnPerView / this.canvas.clientHeight;
        this.moveCamera((camera) => camera.orbit(turn * dx, turn * dy));
      },
      pan: (dx, dy) => this.moveCamera((camera) => camera.pan(dx, dy, this.canvas.clientHeight)),
      zoom: (factor) => this.moveCamera((camera) => camera.zoom(factor)),
    });
  }

  dispose(): void {
    this.gestures.dispose();
  }

  moveCamera(move: (camera: OrbitCamera) => void): void {
    move(this.orbitCamera);
    this.callbacks.onCameraChange(this.orbitCamera.state);
    this.callbacks.onInvalidate();
  }

  /** What lies under a place of the canvas (CSS pixels); pins before vertices before springs. Things in front do not hide those behind. */
  pick(x: number, y: number, pointerType: string): Hit | null {
    const view = this.viewAt(x, y);
    if (!view) return null;
    const hit = (kind: Hit['kind'], index: number, drawn: Float32Array): Hit => {
      return { kind, index, bounds: boundsNear(drawn, x, y) };
    };
    const pin = this.pickPin(view, x, y, pointerType);
    if (pin !== null) return hit('vertex', view.frame.pinned[pin], Float32Array.of(x, y));
    const tolerance = tolerancesFor(pointerType, view.springPixels);
    const points = this.onScreen(view, view.points);
    const vertex = nearestPoint(points, x, y, tolerance.vertex);
    if (vertex !== null) return hit('vertex', vertex, points.subarray(2 * vertex, 2 * vertex + 2));
    const ends = this.onScreen(view, view.springEnds());
    const spring = nearestSegment(ends, x, y, tolerance.spring);
    return spring === null ? null : hit('spring', spring, ends.subarray(4 * spring, 4 * spring + 4));
  }

  private pickPin(view: DrawnView, x: number, y: number, pointerType: string): number | null {
    const tolerance = tolerancesFor(pointerType, view.springPixels);
    return nearestPoint(this.onScreen(view, view.frame.targets), x, y, tolerance.pin);
  }

  private onScreen(view: DrawnView, points: Float64Array | Float32Array): Float32Array {
    this.orbitCamera.setAspect(view.rectangle.width / view.rectangle.height);
    return projectPoints(points, worldToClip(this.orbitCamera.camera), view.rectangle);
  }

  private grab(x: number, y: number, pointerType: string): boolean {
    const view = this.viewAt(x, y);
    const pin = view && this.pickPin(view, x, y, pointerType);
    if (view === null || pin === null) return false;
    const centre = new Vector3().fromArray(view.frame.targets, 3 * pin);
    const plane = facingPlane(this.orbitCamera.camera, centre);
    const touched = this.pointUnder(view, x, y, plane);
    if (!touched) return false;
    this.held = { vertex: view.frame.pinned[pin], view, plane, grip: centre.sub(touched), moved: false };
    return true;
  }

  private drag(x: number, y: number): void {
    const held = this.held;
    const touched = held && this.pointUnder(held.view, x, y, held.plane);
    if (!touched) return;
    if (!held.moved) this.callbacks.onDragStart(held.vertex);
    held.moved = true;
    this.canvas.style.cursor = 'grabbing';
    this.callbacks.onDrag(held.vertex, Float64Array.from(touched.add(held.grip)));
  }

  private release(): void {
    if (this.held?.moved) this.callbacks.onDragEnd(this.held.vertex);
    this.held = null;
    this.canvas.style.cursor = '';
  }

  private pointUnder(view: DrawnView, x: number, y: number, plane: Plane): Vector3 | null {
    this.orbitCamera.setAspect(view.rectangle.width / view.rectangle.height);
    return pointOnPlane(this.orbitCamera.camera, view.rectangle, x, y, plane);
  }

  private tap(x: number, y: number, pointerType: string, shift: boolean): void {
    const hit = this.pick(x, y, pointerType);
    if (!shift) this.callbacks.onSelect(hit);
    else if (hit?.kind === 'vertex') this.callbacks.onPinToggle(hit.index);
  }

  private hover(place: { x: number; y: number } | null): void {
    const hit = place && this.pick(place.x, place.y, 'mouse');
    const before = this.hovered;
    this.hovered = hit;
    if (hit?.kind === before?.kind && hit?.index === before?.index) return;
    this.canvas.style.cursor = hit ? 'pointer' : '';
    this.callbacks.onHover(hit);
  }
}
