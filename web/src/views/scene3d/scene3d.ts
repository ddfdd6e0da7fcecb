import { WebGLRenderer } from 'three';
import type { Camera } from '../../app/state.ts';
import { framingOfFall, framingOfNow } from './framing.ts';
import { createInk, setInkColour } from './ink.ts';
import { type DrawnView, Interaction } from './interaction.ts';
import { OrbitCamera } from './orbit_camera.ts';
import { lightPalette } from './palette.ts';
import { projectPoints, worldToClip } from './projection.ts';
import { SceneContent } from './scene_content.ts';
import { type StagedFrame, stageOf } from './stages.ts';
import type {
  Rectangle,
  Scene3DCallbacks,
  Scene3DFrame,
  Scene3DLegend,
  Scene3DModel,
  Scene3DOptions,
  ScreenPoint,
  ViewName,
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
  /** The scene before, until this one has been drawn once: so that the shader programs stay, which both use. */
  private outgoing: SceneContent | null = null;
  /** Whether the camera still has to be set for this scene, has been, or is the reader's. */
  private framing: 'due' | 'done' | 'reader' = 'due';
  private staged: StagedFrame | null = null;
  private legend: Scene3DLegend | null = null;
  private viewports = new Viewports(null, null);
  /** CSS pixels. Reading it from the canvas while drawing would make the browser lay out the page. */
  private canvasSize = { width: 0, height: 0 };
  private options: Scene3DOptions = {
    exaggeration: 'automatic',
    showSprings: true,
    showSurface: true,
    selected: { spring: null, vertex: null },
    pointedAt: { spring: null, vertex: null },
    lit: { localSprings: false, globalSprings: false, vertices: false },
    palette: lightPalette,
    strainRange: 'automatic',
  };

  constructor(canvas: HTMLCanvasElement, callbacks: Scene3DCallbacks) {
    this.canvas = canvas;
    this.callbacks = callbacks;
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

  /** Replaces the scene. Its first drawing brings all of it into view, with room to fall, unless `setCamera` comes first. */
  setScene(model: Scene3DModel): void {
    this.outgoing?.dispose();
    this.outgoing = this.content;
    this.content = new SceneContent(this.ink, model, () => this.callbacks.onInvalidate());
    this.interaction.hovered = null;
    this.orbitCamera.setScene(model.V);
    this.framing = 'due';
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

  /**
   * Where the views lie on the canvas; null hides one. To be called whenever the canvas changes its size, too.
   * The scene is brought into view again, unless the reader has moved the camera.
   */
  setViewports(local: Rectangle | null, global: Rectangle | null): void {
    const before = this.viewports;
    this.viewports = new Viewports(local, global);
    this.canvasSize = { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
    if (this.framing === 'done' && this.viewports.narrowestAspect !== before.narrowestAspect) this.framing = 'due';
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

    if (this.framing === 'due') {
      this.orbitCamera.fit(framingOfFall(content.V, staged.frame.pinned), this.viewports.narrowestAspect);
      this.framing = 'done';
    }
    const { camera } = this.orbitCamera;
    const legend = content.refresh(staged, this.options, this.orbitCamera.pixelsPerMetre(this.viewports.height));
    if (legend !== this.legend) this.callbacks.onLegend(legend);
    this.legend = legend;

    this.renderer.setScissorTest(true);
    for (const { name, rectangle } of this.viewports.shown) {
      const { x, y, width, height } = rectangle;
      const bottom = this.canvasSize.height - y - height;
      this.renderer.setViewport(x, bottom, width, height);
      this.renderer.setScissor(x, bottom, width, height);
      this.orbitCamera.setAspect(width / height);
      this.prepareInk(content, rectangle);
      this.renderer.render(content.views[name].scene, camera);
    }
    this.outgoing?.dispose();
    this.outgoing = null;
  }

  get camera(): Camera {
    return this.orbitCamera.state;
  }

  setCamera(state: Camera): void {
    this.orbitCamera.state = state;
    this.framing = 'reader';
    this.callbacks.onInvalidate();
  }

  /** Brings into view where the vertices and pins are now. */
  fit(): void {
    const drawn = this.drawn();
    if (!drawn) return;
    const { p, targets } = drawn.staged.frame;
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
  projectToScreen(vertex: number, name: ViewName): ScreenPoint | null {
    const viewport = this.viewports.named(name);
    if (!viewport || !this.content) return null;
    const { width, height } = viewport.rectangle;
    const point = this.content.views[name].points.slice(3 * vertex, 3 * vertex + 3);
    this.orbitCamera.setAspect(width / height);
    const [x, y] = projectPoints(point, worldToClip(this.orbitCamera.camera), viewport.rectangle);
    return Number.isNaN(x) ? null : { x, y };
  }

  dispose(): void {
    this.stop.abort();
    this.interaction.dispose();
    this.outgoing?.dispose();
    this.content?.dispose();
    this.renderer.dispose();
  }

  /** What there is to draw, or null. */
  private drawn(): { content: SceneContent; staged: StagedFrame } | null {
    const { content, staged } = this;
    if (!content || !staged || this.viewports.shown.length === 0) return null;
    return staged.frame.p.length === content.V.length ? { content, staged } : null;
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
    const view = content.views[viewport.name];
    const springPixels = content.typicalRestLength * this.orbitCamera.pixelsPerMetre(this.viewports.height);
    return { ...viewport, points: view.points, springEnds: () => view.springEnds(), frame: staged.frame, springPixels };
  }
}
