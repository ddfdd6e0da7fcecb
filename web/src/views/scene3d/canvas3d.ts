import type { Scene } from 'three';
import type { Camera } from '../../app/state.ts';
import { framingOfFall, framingOfNow } from './framing.ts';
import type { Ink } from './ink.ts';
import { InkCanvas } from './ink_canvas.ts';
import { Interaction } from './interaction.ts';
import { OrbitCamera } from './orbit_camera.ts';
import { projectPoints, worldToClip } from './projection.ts';
import type { CanvasCallbacks, Scene3DFrame, ScreenPoint } from './types.ts';
import type { DrawnView, Poke } from './view_picker.ts';
import { type Viewport, Viewports } from './viewports.ts';

/** A net as a view draws it. */
export interface View {
  scene: Scene;
  /** #V×3, metres. */
  points: Float64Array;
  /** #E×6, metres: both ends of every spring. */
  springEnds(): Float32Array;
}

/** What there is to draw. */
export interface Picture extends Pick<Scene3DFrame, 'p' | 'pinned' | 'targets'> {
  /** #V×3, metres. */
  V: Float64Array;
  /** Metres. */
  typicalRestLength: number;
  /** Null where only pins can be dragged. */
  poke: Poke | null;
  view(name: string): View;
  /** Makes the views ready to be drawn. */
  refresh(pixelsPerMetre: number): void;
}

/** Views of nets that share a scene: one renderer, one canvas, one camera. It draws when `render()` is called and never by itself. */
export class Canvas3D {
  private readonly callbacks: CanvasCallbacks;
  /** Null when there is nothing to draw. */
  private readonly picture: () => Picture | null;
  private readonly inkCanvas: InkCanvas;
  private readonly orbitCamera = new OrbitCamera();
  private readonly interaction: Interaction;
  /** Whether the camera still has to be set for this scene, has been, or is the reader's. */
  private framing: 'due' | 'done' | 'reader' = 'due';
  private viewports = new Viewports([]);

  constructor(canvas: HTMLCanvasElement, callbacks: CanvasCallbacks, picture: () => Picture | null) {
    this.callbacks = callbacks;
    this.picture = picture;
    this.inkCanvas = new InkCanvas(canvas, callbacks);
    this.interaction = new Interaction(canvas, this.orbitCamera, (x, y) => this.viewAt(x, y), {
      ...callbacks,
      onCameraChange: (camera) => {
        this.framing = 'reader';
        callbacks.onCameraChange(camera);
      },
    });
  }

  get ink(): Ink {
    return this.inkCanvas.ink;
  }

  /** Another scene. Its first drawing brings all of it into view, with room to fall, unless the camera is set first. `V` #V×3, metres. */
  begin(V: Float64Array): void {
    this.interaction.hovered = null;
    this.orbitCamera.setScene(V);
    this.framing = 'due';
    this.callbacks.onInvalidate();
  }

  /**
   * Where the views lie on the canvas. To be called whenever the canvas changes its size, too.
   * The scene is brought into view again, unless the reader has moved the camera.
   */
  setViewports(all: readonly Viewport[]): void {
    const before = this.viewports;
    this.viewports = new Viewports(all);
    this.inkCanvas.measure();
    if (this.framing === 'done' && this.viewports.narrowestAspect !== before.narrowestAspect) this.framing = 'due';
    this.callbacks.onInvalidate();
  }

  /** Returns what was drawn. */
  render(background: string): Picture | null {
    this.inkCanvas.clear(background);
    const picture = this.drawn();
    if (!picture) return null;

    if (this.framing === 'due') {
      this.orbitCamera.fit(framingOfFall(picture.V, picture.pinned), this.viewports.narrowestAspect);
      this.framing = 'done';
    }
    picture.refresh(this.orbitCamera.pixelsPerMetre(this.viewports.height));

    for (const { name, rectangle } of this.viewports.shown)
      this.inkCanvas.draw(picture.view(name).scene, this.orbitCamera, rectangle, picture.typicalRestLength / 2);
    return picture;
  }

  get camera(): Camera {
    return this.orbitCamera.state;
  }

  set camera(state: Camera) {
    this.orbitCamera.state = state;
    this.framing = 'reader';
    this.callbacks.onInvalidate();
  }

  /** Brings into view where the vertices and pins are now. */
  fit(): void {
    const picture = this.drawn();
    if (!picture) return;
    const { p, targets } = picture;
    this.interaction.moveCamera((camera) => camera.fit(framingOfNow(p, targets), this.viewports.narrowestAspect));
  }

  /** Radians. */
  orbit(azimuth: number, polar: number): void {
    this.interaction.moveCamera((camera) => camera.orbit(azimuth, polar));
  }

  /** Nearer by a factor over 1. */
  zoom(factor: number): void {
    this.interaction.moveCamera((camera) => camera.zoom(factor));
  }

  /** CSS pixels of the canvas at which a view shows a vertex; null when it is behind the camera or the view hidden. */
  projectToScreen(vertex: number, name: string): ScreenPoint | null {
    const points = this.drawn()?.view(name).points;
    return points ? this.projectPoint(points.subarray(3 * vertex, 3 * vertex + 3), name) : null;
  }

  /** Likewise of any point; #3, metres. */
  projectPoint(point: Float64Array, name: string): ScreenPoint | null {
    const viewport = this.viewports.named(name);
    if (!viewport) return null;
    const { width, height } = viewport.rectangle;
    this.orbitCamera.setAspect(width / height);
    const [x, y] = projectPoints(point, worldToClip(this.orbitCamera.camera), viewport.rectangle);
    return Number.isNaN(x) ? null : { x, y };
  }

  /** Of the canvas no other use can be made afterwards. */
  dispose(): void {
    this.interaction.dispose();
    this.inkCanvas.dispose();
  }

  private drawn(): Picture | null {
    return this.viewports.shown.length === 0 ? null : this.picture();
  }

  private viewAt(x: number, y: number): DrawnView | null {
    const viewport = this.viewports.at(x, y);
    const picture = this.drawn();
    if (!viewport || !picture) return null;
    const view = picture.view(viewport.name);
    return {
      rectangle: viewport.rectangle,
      points: view.points,
      springEnds: () => view.springEnds(),
      frame: picture,
      poke: picture.poke,
      springPixels: picture.typicalRestLength * this.orbitCamera.pixelsPerMetre(this.viewports.height),
    };
  }
}
