import { Vector2, WebGLRenderer } from 'three';
import { framingOf } from './framing.ts';
import { createInk, setInkColour } from './ink.ts';
import { type DrawnView, Interaction } from './interaction.ts';
import { OrbitCamera } from './orbit_camera.ts';
import { lightPalette } from './palette.ts';
import { projectPoints, worldToClip } from './projection.ts';
import { SceneContent } from './scene_content.ts';
import { type StagedFrame, stageOf } from './stages.ts';
import {
  type CameraState,
  NoWebGLError,
  type Rectangle,
  type Scene3DCallbacks,
  type Scene3DFrame,
  type Scene3DLegend,
  type Scene3DModel,
  type Scene3DOptions,
  type ScreenPoint,
  type ViewName,
} from './types.ts';
import { Viewports } from './viewports.ts';

/** More device pixels than this in a CSS pixel cost without being seen. */
const mostPixelRatio = 2;

/** Two views of one simulation: one renderer, one canvas, one camera. It draws when `render()` is called and never by itself. */
export class Scene3D {
  private readonly canvas: HTMLCanvasElement;
  private readonly callbacks: Scene3DCallbacks;
  private readonly renderer: WebGLRenderer;
  private readonly ink = createInk();
  private readonly orbitCamera = new OrbitCamera();
  private readonly interaction: Interaction;
  private readonly stop = new AbortController();
  private content: SceneContent | null = null;
  /** Whether the camera has been set for this scene. */
  private framed = false;
  private staged: StagedFrame | null = null;
  private legend: Scene3DLegend | null = null;
  private viewports = new Viewports(null, null);
  private options: Scene3DOptions = {
    exaggeration: 'automatic',
    showSprings: true,
    showSurface: true,
    selectedSpring: null,
    selectedVertex: null,
    palette: lightPalette,
    strainRange: 'automatic',
  };

  constructor(canvas: HTMLCanvasElement, callbacks: Scene3DCallbacks) {
    this.canvas = canvas;
    this.callbacks = callbacks;
    const context = canvas.getContext('webgl2', { antialias: true, alpha: false });
    if (!context) throw new NoWebGLError('This browser gives no WebGL 2 context.');
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.autoClear = false;
    this.interaction = new Interaction(canvas, this.orbitCamera, (x, y) => this.viewAt(x, y), callbacks);
    const { signal } = this.stop;
    canvas.addEventListener('webglcontextlost', () => callbacks.onContextLost(), { signal });
    canvas.addEventListener('webglcontextrestored', () => callbacks.onInvalidate(), { signal });
  }

  /** Replaces the scene. Its first drawing brings all of it into view, unless `setCamera` comes first. */
  setScene(model: Scene3DModel): void {
    this.content?.dispose();
    this.content = new SceneContent(this.ink, model, () => this.callbacks.onInvalidate());
    this.interaction.hovered = null;
    this.orbitCamera.setScene(model.V);
    this.framed = false;
    this.callbacks.onInvalidate();
  }

  /**
   * `progress`: how much of the tear (at local) or the stitch (at global) has been animated, 0 … 1.
   * Scene and frame may be set in either order: nothing is drawn while they are of different sizes.
   */
  setFrame(frame: Scene3DFrame, progress = 1): void {
    this.staged = { frame, stage: stageOf(frame, progress) };
    this.callbacks.onInvalidate();
  }

  setOptions(options: Partial<Scene3DOptions>): void {
    this.options = { ...this.options, ...options };
    this.callbacks.onInvalidate();
  }

  /** Where the views lie on the canvas; null hides one. To be called whenever the canvas changes its size, too. */
  setViewports(local: Rectangle | null, global: Rectangle | null): void {
    this.viewports = new Viewports(local, global);
    this.callbacks.onInvalidate();
  }

  render(): void {
    this.followCanvasSize();
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(this.options.palette.background);
    this.renderer.clear();
    const drawn = this.drawn();
    if (!drawn) return;
    const { content, staged } = drawn;

    if (!this.framed) this.fitCamera(content, staged);
    this.framed = true;
    const { camera } = this.orbitCamera;
    const legend = content.refresh(
      staged,
      this.options,
      this.orbitCamera.pixelsPerMetre(this.viewports.height),
      this.interaction.hovered,
      camera.position,
    );
    if (legend !== this.legend) this.callbacks.onLegend(legend);
    this.legend = legend;

    this.renderer.setScissorTest(true);
    for (const { name, rectangle } of this.viewports.shown) {
      const { x, y, width, height } = rectangle;
      const bottom = this.canvas.clientHeight - y - height;
      this.renderer.setViewport(x, bottom, width, height);
      this.renderer.setScissor(x, bottom, width, height);
      this.orbitCamera.setAspect(width / height);
      this.prepareInk(content, rectangle);
      this.renderer.render(content.views[name].scene, camera);
    }
  }

  get camera(): CameraState {
    return this.orbitCamera.state;
  }

  setCamera(state: CameraState): void {
    this.orbitCamera.state = state;
    this.framed = true;
    this.callbacks.onInvalidate();
  }

  /** Frames the whole scene. */
  fit(): void {
    const drawn = this.drawn();
    if (drawn) this.interaction.moveCamera(() => this.fitCamera(drawn.content, drawn.staged));
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
  projectToScreen(vertex: number, name: ViewName): ScreenPoint | null {
    const viewport = this.viewports.named(name);
    if (!viewport || !this.content) return null;
    const { width, height } = viewport.rectangle;
    const point = this.content.views[name].points.slice(3 * vertex, 3 * vertex + 3);
    this.orbitCamera.setAspect(width / height);
    const [x, y] = projectPoints(point, 3, worldToClip(this.orbitCamera.camera), viewport.rectangle);
    return Number.isNaN(x) ? null : { x, y };
  }

  dispose(): void {
    this.stop.abort();
    this.interaction.dispose();
    this.content?.dispose();
    this.renderer.dispose();
  }

  /** What there is to draw, or null. */
  private drawn(): { content: SceneContent; staged: StagedFrame } | null {
    const { content, staged } = this;
    if (!content || !staged || this.viewports.shown.length === 0) return null;
    return staged.frame.p.length === content.V.length ? { content, staged } : null;
  }

  private fitCamera({ V }: SceneContent, { frame }: StagedFrame): void {
    this.orbitCamera.fit(framingOf(V, frame.pinned), this.viewports.narrowestAspect);
  }

  /** Just before drawing, or the canvas would be seen empty: changing its size clears it. */
  private followCanvasSize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    const pixelRatio = Math.min(window.devicePixelRatio, mostPixelRatio);
    const { x, y } = this.renderer.getSize(new Vector2());
    if (x === clientWidth && y === clientHeight && pixelRatio === this.renderer.getPixelRatio()) return;
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.setSize(clientWidth, clientHeight, false);
  }

  private prepareInk(content: SceneContent, { width, height }: Rectangle): void {
    const pixelRatio = this.renderer.getPixelRatio();
    const { distance, sceneRadius } = this.orbitCamera;
    this.ink.viewport.value.set(width, height).multiplyScalar(pixelRatio);
    this.ink.pixelRatio.value = pixelRatio;
    setInkColour(this.ink.background.value, this.options.palette.background);
    this.ink.fadeFrom.value = distance;
    this.ink.fadeTo.value = distance + 3 * sceneRadius;
    this.ink.haloDepth.value = content.typicalRestLength / 2;
  }

  private viewAt(x: number, y: number): DrawnView | null {
    const viewport = this.viewports.at(x, y);
    const drawn = this.drawn();
    if (!viewport || !drawn) return null;
    const { content, staged } = drawn;
    const { points, segments } = content.views[viewport.name];
    const springPixels = content.typicalRestLength * this.orbitCamera.pixelsPerMetre(this.viewports.height);
    return { ...viewport, points, segments: segments.data, frame: staged.frame, springPixels };
  }
}
