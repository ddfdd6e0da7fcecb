import { Plane, Vector3 } from 'three';
import { type Point3, reachOf } from '../../app/kinematics.ts';
import { Gestures } from '../../lib/gestures.ts';
import { floorRadius } from './arm_floor.ts';
import type { ArmPicture } from './arm_picture.ts';
import type { Arm3D } from './arm3d.ts';
import { nearestPoint } from './picking.ts';
import { facingPlane, pointOnPlane, projectPoints, worldToClip } from './projection.ts';

/** Radians that a pointer turns the camera by crossing the height of the canvas. */
const turnPerView = 5;
/** CSS pixels within which a pointer takes hold of something; fingers are thicker. */
const nearness = { mouse: 14, other: 28 };

const floor = new Plane(new Vector3(0, 1, 0), 0);

export interface ArmPointerCallbacks {
  /** m. */
  onTarget(target: Point3): void;
  /** A mouse rests on a joint, or no longer does. */
  onJoint(joint: number | null): void;
  /** Whether presses draw on the floor, and so do not move the target: what was drawn would be given up for it. */
  mayDraw(): boolean;
  onPen(place: Point3): void;
  onPenUp(): void;
}

const nothing = () => {};

/** Whether a place of the plane lies where the floor is seen. */
function isOnFloor({ x, z }: Vector3, picture: ArmPicture): boolean {
  return Math.hypot(x - picture.root[0], z - picture.root[2]) < floorRadius(reachOf(picture));
}

interface Held {
  plane: Plane;
  /** m: kept, so that what is held does not jump to the pointer. */
  aside: Vector3;
  move(to: Vector3): void;
  end(): void;
}

/** Pointers on the arm's canvas: they take the target in the plane that faces the reader, its shadow along the floor, draw, or move the camera. */
export class ArmPointers {
  private readonly canvas: HTMLCanvasElement;
  private readonly arm: Arm3D;
  private readonly callbacks: ArmPointerCallbacks;
  private readonly gestures: Gestures;
  private held: Held | null = null;

  constructor(canvas: HTMLCanvasElement, arm: Arm3D, callbacks: ArmPointerCallbacks) {
    this.canvas = canvas;
    this.arm = arm;
    this.callbacks = callbacks;
    this.gestures = new Gestures(canvas, {
      grab: (x, y, pointerType) => this.grab(x, y, pointerType),
      drag: (x, y) => this.drag(x, y),
      release: () => this.release(),
      tap: (x, y, pointerType) => callbacks.onJoint(this.jointAt(x, y, pointerType)),
      hover: (place) => this.hover(place),
      orbit: (dx, dy) => {
        const turn = -turnPerView / canvas.clientHeight;
        arm.moveCamera((camera) => camera.orbit(turn * dx, turn * dy));
      },
      pan: (dx, dy) => arm.moveCamera((camera) => camera.pan(dx, dy, canvas.clientHeight)),
      zoom: (factor) => arm.moveCamera((camera) => camera.zoom(factor)),
    });
  }

  dispose(): void {
    this.gestures.dispose();
  }

  private grab(x: number, y: number, pointerType: string): boolean {
    this.held = this.holdOf(x, y, pointerType);
    return this.held !== null;
  }

  private holdOf(x: number, y: number, pointerType: string): Held | null {
    const eye = this.arm.eye();
    if (!eye) return null;
    const { onTarget, onPen, onPenUp, mayDraw } = this.callbacks;
    const target = new Vector3(...eye.picture.target);
    const part = this.targetPartAt(x, y, pointerType);
    if (part === 'target') {
      const plane = facingPlane(eye.camera, target);
      const touched = pointOnPlane(eye.camera, eye.view, x, y, plane);
      if (!touched) return null;
      return { plane, aside: target.sub(touched), move: (to) => onTarget(to.toArray()), end: nothing };
    }
    const touched = pointOnPlane(eye.camera, eye.view, x, y, floor);
    if (!touched) return null;
    if (part === 'shadow') {
      const foot = new Vector3(target.x, 0, target.z);
      return {
        plane: floor,
        aside: foot.sub(touched),
        move: (to) => onTarget([to.x, target.y, to.z]),
        end: nothing,
      };
    }
    if (!mayDraw() || !isOnFloor(touched, eye.picture)) return null;
    onPen(touched.toArray());
    return { plane: floor, aside: new Vector3(), move: (to) => onPen(to.toArray()), end: onPenUp };
  }

  private drag(x: number, y: number): void {
    const { held } = this;
    const eye = this.arm.eye();
    const touched = held && eye && pointOnPlane(eye.camera, eye.view, x, y, held.plane);
    if (!touched) return;
    this.canvas.style.cursor = 'grabbing';
    held.move(touched.add(held.aside));
  }

  private release(): void {
    this.held?.end();
    this.held = null;
    this.canvas.style.cursor = '';
  }

  private hover(place: { x: number; y: number } | null): void {
    const part = place && this.targetPartAt(place.x, place.y, 'mouse');
    const joint = place && !part ? this.jointAt(place.x, place.y, 'mouse') : null;
    this.callbacks.onJoint(joint);
    this.canvas.style.cursor = part ? 'grab' : joint !== null ? 'pointer' : this.callbacks.mayDraw() ? 'crosshair' : '';
  }

  /** Where both are under the pointer, the target: it can be lifted off the floor again. Neither while the pen is in hand. */
  private targetPartAt(x: number, y: number, pointerType: string): 'target' | 'shadow' | null {
    if (this.callbacks.mayDraw()) return null;
    const target = this.arm.eye()?.picture.target;
    if (!target) return null;
    const parts = Float64Array.of(...target, target[0], 0, target[2]);
    const part = this.nearest(parts, x, y, pointerType);
    if (part === null) return null;
    return part === 1 && this.nearest(parts.subarray(0, 3), x, y, pointerType) === null ? 'shadow' : 'target';
  }

  private jointAt(x: number, y: number, pointerType: string): number | null {
    const joints = this.arm.eye()?.picture.x;
    return joints ? this.nearest(joints, x, y, pointerType) : null;
  }

  private nearest(points: Float64Array, x: number, y: number, pointerType: string): number | null {
    const eye = this.arm.eye();
    if (!eye) return null;
    const tolerance = pointerType === 'mouse' ? nearness.mouse : nearness.other;
    return nearestPoint(projectPoints(points, worldToClip(eye.camera), eye.view), x, y, tolerance);
  }
}
