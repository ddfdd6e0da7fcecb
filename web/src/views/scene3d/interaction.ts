import { type Plane, Vector3 } from 'three';
import { Gestures } from '../../lib/gestures.ts';
import type { OrbitCamera } from './orbit_camera.ts';
import { facingPlane } from './projection.ts';
import { pullBy } from './pull.ts';
import type { CanvasCallbacks, Hit } from './types.ts';
import { type DrawnView, ViewPicker } from './view_picker.ts';

/** Radians that a pointer turns the camera by crossing the height of the canvas. */
const turnPerView = 5;

interface Held {
  view: DrawnView;
  /** In it, what is held follows the pointer. */
  plane: Plane;
  moved: boolean;
  begin(): void;
  /** `touched`: where the pointer now meets the plane. */
  drag(touched: Vector3): void;
  end(): void;
}

/** Pointers on the canvas: they look at things, select them, drag pins, pull at nets, and otherwise move the camera. */
export class Interaction {
  hovered: Hit | null = null;
  private readonly canvas: HTMLCanvasElement;
  private readonly orbitCamera: OrbitCamera;
  private readonly viewAt: (x: number, y: number) => DrawnView | null;
  private readonly callbacks: CanvasCallbacks;
  private readonly picker: ViewPicker;
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
    this.picker = new ViewPicker(orbitCamera);
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

  /** What lies under a place of the canvas (CSS pixels). */
  pick(x: number, y: number, pointerType: string): Hit | null {
    const view = this.viewAt(x, y);
    return view && this.picker.pick(view, x, y, pointerType);
  }

  private grab(x: number, y: number, pointerType: string): boolean {
    const view = this.viewAt(x, y);
    this.held = view && (this.grabPin(view, x, y, pointerType) ?? this.grabNet(view, x, y, pointerType));
    return this.held !== null;
  }

  private grabPin(view: DrawnView, x: number, y: number, pointerType: string): Held | null {
    const hit = this.picker.pickPin(view, x, y, pointerType);
    if (!hit) return null;
    const { pinned, targets } = view.frame;
    const centre = new Vector3().fromArray(targets, 3 * pinned.indexOf(hit.index));
    const plane = facingPlane(this.orbitCamera.camera, centre);
    const touched = this.picker.pointOn(plane, view, x, y);
    if (!touched) return null;
    const aside = centre.sub(touched); // kept, so that the pin does not jump to the pointer
    return {
      view,
      plane,
      moved: false,
      begin: () => this.callbacks.onDragStart(hit.index),
      drag: (now) => this.callbacks.onDrag(hit.index, Float64Array.from(now.add(aside))),
      end: () => this.callbacks.onDragEnd(hit.index),
    };
  }

  private grabNet(view: DrawnView, x: number, y: number, pointerType: string): Held | null {
    const handhold = this.picker.handhold(view, x, y, pointerType);
    if (!handhold || !view.poke) return null;
    const { spot, grip } = handhold;
    const { stiffness } = view.poke;
    const plane = facingPlane(this.orbitCamera.camera, spot.point);
    const from = this.picker.pointOn(plane, view, x, y);
    if (!from) return null;
    this.callbacks.onMark?.(grip.vertices);
    return {
      view,
      plane,
      moved: false,
      begin: () => {},
      drag: (now) => this.callbacks.onPull?.(pullBy(grip, now.sub(from).toArray(), stiffness)),
      end: () => this.callbacks.onPull?.(null),
    };
  }

  private drag(x: number, y: number): void {
    const held = this.held;
    const touched = held && this.picker.pointOn(held.plane, held.view, x, y);
    if (!touched) return;
    if (!held.moved) held.begin();
    held.moved = true;
    this.canvas.style.cursor = 'grabbing';
    held.drag(touched);
  }

  private release(): void {
    if (this.held?.moved) this.held.end();
    this.held = null;
    this.callbacks.onMark?.(null);
    this.canvas.style.cursor = '';
  }

  private tap(x: number, y: number, pointerType: string, shift: boolean): void {
    const hit = this.pick(x, y, pointerType);
    if (!shift) this.callbacks.onSelect(hit);
    else if (hit?.kind === 'vertex') this.callbacks.onPinToggle(hit.index);
  }

  private hover(place: { x: number; y: number } | null): void {
    const view = place && this.viewAt(place.x, place.y);
    const { hit, handhold } = view ? this.under(view, place.x, place.y) : nothing;
    this.callbacks.onMark?.(handhold?.grip.vertices ?? null);
    const before = this.hovered;
    this.hovered = hit;
    this.canvas.style.cursor = handhold ? 'grab' : hit ? 'pointer' : '';
    if (hit?.kind !== before?.kind || hit?.index !== before?.index) this.callbacks.onHover(hit);
  }

  /** Where a net can be pulled at, pins are all that is pointed at besides. */
  private under(view: DrawnView, x: number, y: number) {
    if (!view.poke) return { hit: this.picker.pick(view, x, y, 'mouse'), handhold: null };
    const hit = this.picker.pickPin(view, x, y, 'mouse');
    return { hit, handhold: hit ? null : this.picker.handhold(view, x, y, 'mouse') };
  }
}

const nothing = { hit: null, handhold: null };
