import { type Scene, WebGLRenderer } from 'three';
import type { Camera } from '../../app/state.ts';
import type { Rectangle } from '../../lib/rectangle.ts';
import { framingOfFall, framingOfNow } from './framing.ts';
import { createInk, setInkColour } from './ink.ts';
import { Interaction } from './interaction.ts';
import { OrbitCamera } from './orbit_camera.ts';
import { projectPoints, worldToClip } from './projection.ts';
import type { CanvasCallbacks, Scene3DFrame, ScreenPoint } from './types.ts';
import type { DrawnView, Poke } from './view_picker.ts';
import { type Viewport, Viewports } from './viewports.ts';

/** More device pixels than this in a CSS pixel cost without being seen. */
const mostPixelRatio = 2;

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
  background: string;
  /** Null where only pins can be dragged. */
  poke: Poke | null;
  view(name: string): View;
  /** Makes the views ready to be drawn. */
  refresh(pixelsPerMetre: number): void;
}

/** Views of nets that share a scene: one renderer, one canvas, one camera. It draws when `render()` is called and never by itself. */
export class Canvas3D {
  readonly ink = createInk();
  private readonly canvas: HTMLCanvasElement;
  private readonly callbacks: CanvasCallbacks;
  /** Null when there is nothing to draw. */
  private readonly picture: () => Picture | null;
  private readonly renderer: WebGLRenderer;
  private readonly orbitCamera = new OrbitCamera();
  private readonly interaction: Interaction;
  private readonly stop = new AbortController();
  /** Whether the camera still has to be set for this scene, has been, or is the reader's. */
  private framing: 'due' | 'done' | 'reader' = 'due';
  private viewports = new Viewports([]);
  /** CSS pixels. Reading it from the canvas while drawing would make the browser lay out the page. */
  private canvasSize = { width: 0, height: 0 };

  constructor(canvas: HTMLCanvasElement, callbacks: CanvasCallbacks, picture: () => Picture | null) {
    this.canvas = canvas;
    this.callbacks = callbacks;
    this.picture = picture;
    const context = canvas.getContext('webgl2', { antialias: true, alpha: false });
    if (!context) throw new Error('This browser gives no WebGL 2 context.');
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.autoClear = false;
    this.interaction = new Interaction(canvas, this.orbitCamera, (x, y) => this.viewAt(x, y), {
      ...callbacks,
      onCameraChange: (camera) => {
        this.framing = 'reader';
        callbacks.onCameraChange(camera);
      },
    });
    const { signal } = this.stop;
    canvas.addEventListener('webglcontextlost', () => callbacks.onContextLost(), { signal });
    canvas.addEventListener('webglcontextrestored', () => callbacks.onInvalidate(), { signal });
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
    this.canvasSize = { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
    if (this.framing === 'done' && this.viewports.narrowestAspect !== before.narrowestAspect) this.framing = 'due';
    this.callbacks.onInvalidate();
  }

  /** Returns what was drawn. */
  render(background: string): Picture | null {
    this.followCanvasSize();
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(background);
    this.renderer.clear();
    const picture = this.drawn();
    if (!picture) return null;

    if (this.framing === 'due') {
      this.orbitCamera.fit(framingOfFall(picture.V, picture.pinned), this.viewports.narrowestAspect);
      this.framing = 'done';
    }
    picture.refresh(this.orbitCamera.pixelsPerMetre(this.viewports.height));

    this.renderer.setScissorTest(true);
    for (const { name, rectangle } of this.viewports.shown) {
      const { x, y, width, height } = rectangle;
      const bottom = this.canvasSize.height - y - height;
      this.renderer.setViewport(x, bottom, width, height);
      this.renderer.setScissor(x, bottom, width, height);
      this.orbitCamera.setAspect(width / height);
      this.prepareInk(picture, rectangle);
      this.renderer.render(picture.view(name).scene, this.orbitCamera.camera);
    }
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
    this.stop.abort();
    this.interaction.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss(); // a page has sixteen contexts or so, and rooms come and go faster than garbage is collected
  }

  private drawn(): Picture | null {
    return this.viewports.shown.length === 0 ? null : this.picture();
  }

  /** Just before drawing, or the canvas would be seen empty: changing its size clears it. */
  private followCanvasSize(): void {
    const { width, height } = this.canvasSize;
    const pixelRatio = Math.min(window.devicePixelRatio, mostPixelRatio);
    const sized =
      this.canvas.width === Math.floor(width * pixelRatio) && this.canvas.height === Math.floor(height * pixelRatio);
    if (sized && pixelRatio === this.renderer.getPixelRatio()) return;
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.setSize(width, height, false);
  }

  private prepareInk({ background, typicalRestLength }: Picture, { width, height }: Rectangle): void {
    const pixelRatio = this.renderer.getPixelRatio();
    const { distance, sceneRadius } = this.orbitCamera;
    this.ink.viewport.value.set(width, height).multiplyScalar(pixelRatio);
    this.ink.pixelRatio.value = pixelRatio;
    setInkColour(this.ink.background.value, background);
    this.ink.fadeFrom.value = distance;
    this.ink.fadeTo.value = distance + 3 * sceneRadius;
    this.ink.haloDepth.value = typicalRestLength / 2;
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
