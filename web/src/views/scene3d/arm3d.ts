import type { Camera as ThreeCamera } from 'three';
import { reachOf } from '../../app/kinematics.ts';
import type { Camera } from '../../app/state.ts';
import type { Rectangle } from '../../lib/rectangle.ts';
import { radiusOf } from './arm_body.ts';
import { ArmContent } from './arm_content.ts';
import { fullFraming, homeFraming } from './arm_framing.ts';
import type { ArmPicture } from './arm_picture.ts';
import type { Framing } from './framing.ts';
import { InkCanvas } from './ink_canvas.ts';
import { OrbitCamera } from './orbit_camera.ts';
import { projectPoints, worldToClip } from './projection.ts';
import type { CanvasCallbacks, ScreenPoint } from './types.ts';

/** CSS pixels: half of what stands for a thing on the page. */
const halfHandle = 12;

/** An arm on a canvas of its own. It draws when `render()` is called and never by itself. */
export class Arm3D {
  readonly orbitCamera = new OrbitCamera();
  private readonly canvas: HTMLCanvasElement;
  private readonly inkCanvas: InkCanvas;
  private readonly content: ArmContent;
  private readonly invalidate: () => void;
  private picture: ArmPicture | null = null;
  private view: Rectangle = { x: 0, y: 0, width: 0, height: 0 };
  /** Whether the camera still has to be set for this chain, has been, or is the reader's. */
  private framing: 'due' | 'done' | 'reader' = 'due';

  constructor(canvas: HTMLCanvasElement, callbacks: Pick<CanvasCallbacks, 'onContextLost' | 'onInvalidate'>) {
    this.canvas = canvas;
    this.invalidate = callbacks.onInvalidate;
    this.inkCanvas = new InkCanvas(canvas, callbacks);
    this.content = new ArmContent(this.inkCanvas.ink);
  }

  show(picture: ArmPicture): void {
    const before = this.picture;
    this.picture = picture;
    if (this.framing === 'done' && before && !isSameChain(before, picture)) this.framing = 'due';
    this.invalidate();
  }

  /** To be called whenever the canvas changes its size. */
  measure(): void {
    const { width } = this.view;
    this.inkCanvas.measure();
    this.view = { x: 0, y: 0, width: this.canvas.clientWidth, height: this.canvas.clientHeight };
    if (this.framing === 'done' && width !== this.view.width) this.framing = 'due';
    this.invalidate();
  }

  render(): void {
    const { picture, view } = this;
    if (!picture || view.width === 0 || view.height === 0) return;
    this.inkCanvas.clear(picture.palette.background);
    if (this.framing === 'due') this.frame(homeFraming(picture));
    this.content.refresh(picture, this.orbitCamera.pixelsPerMetre(view.height));
    this.inkCanvas.draw(this.content.scene, this.orbitCamera, view, radiusOf(reachOf(picture), picture.links.length));
  }

  /** Brings everything into view. */
  fit(): void {
    if (this.picture) this.frame(fullFraming(this.picture));
    this.invalidate();
  }

  /** By the reader. */
  moveCamera(move: (camera: OrbitCamera) => void): void {
    move(this.orbitCamera);
    this.framing = 'reader';
    this.invalidate();
  }

  get camera(): Camera {
    return this.orbitCamera.state;
  }

  /** What the canvas shows, and through which eye; for pointers to find things in. Null before there is anything. */
  eye(): { picture: ArmPicture; camera: ThreeCamera; view: Rectangle } | null {
    const { picture, view } = this;
    if (!picture || view.width === 0) return null;
    this.orbitCamera.setAspect(view.width / view.height);
    return { picture, camera: this.orbitCamera.camera, view };
  }

  /** #×2, CSS pixels of the canvas, of points (#×3, m); NaN behind the camera, and null before there is anything. */
  placesOf(points: Float64Array): Float32Array | null {
    const eye = this.eye();
    return eye && projectPoints(points, worldToClip(eye.camera), eye.view);
  }

  /** Of a point, or the nearest place on the canvas: what stands for a thing must not lie over others. Null behind the camera. */
  placeOnCanvas(point: ArrayLike<number>): ScreenPoint | null {
    const [x, y] = this.placesOf(Float64Array.from(point)) ?? [Number.NaN];
    const { width, height } = this.view;
    const within = (place: number, length: number) => Math.max(halfHandle, Math.min(length - halfHandle, place));
    return Number.isNaN(x) ? null : { x: within(x, width), y: within(y, height) };
  }

  dispose(): void {
    this.content.dispose();
    this.inkCanvas.dispose();
  }

  private frame(framing: Framing): void {
    this.orbitCamera.setScene(framing.points);
    this.orbitCamera.fit(framing, this.view.width / this.view.height);
    this.framing = 'done';
  }
}

function isSameChain(a: ArmPicture, b: ArmPicture): boolean {
  return a.links === b.links && a.root === b.root;
}
