import type { Camera } from '../../app/state.ts';
import type { Rectangle } from '../../lib/rectangle.ts';
import { Canvas3D, type Picture } from './canvas3d.ts';
import { lightPalette } from './palette.ts';
import { SceneContent } from './scene_content.ts';
import { type StagedFrame, stageOf } from './stages.ts';
import type {
  Scene3DCallbacks,
  Scene3DFrame,
  Scene3DLegend,
  Scene3DModel,
  Scene3DOptions,
  ScreenPoint,
  ViewName,
} from './types.ts';

/** The two half-steps of one simulation, a view each. It draws when `render()` is called and never by itself. */
export class Scene3D {
  private readonly canvas: Canvas3D;
  private readonly callbacks: Scene3DCallbacks;
  private content: SceneContent | null = null;
  /** The scene before, until this one has been drawn once: so that the shader programs stay, which both use. */
  private outgoing: SceneContent | null = null;
  private staged: StagedFrame | null = null;
  private legend: Scene3DLegend | null = null;
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
    this.callbacks = callbacks;
    this.canvas = new Canvas3D(canvas, callbacks, () => this.picture());
  }

  /** Replaces the scene. Its first drawing brings all of it into view, with room to fall, unless `setCamera` comes first. */
  setScene(model: Scene3DModel): void {
    this.outgoing?.dispose();
    this.outgoing = this.content;
    this.content = new SceneContent(this.canvas.ink, model, () => this.callbacks.onInvalidate());
    this.canvas.begin(model.V);
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
    this.canvas.setViewports(
      Object.entries({ local, global }).flatMap(([name, rectangle]) => (rectangle ? [{ name, rectangle }] : [])),
    );
  }

  render(): void {
    if (!this.canvas.render(this.options.palette.background)) return;
    this.outgoing?.dispose();
    this.outgoing = null;
  }

  get camera(): Camera {
    return this.canvas.camera;
  }

  setCamera(state: Camera): void {
    this.canvas.camera = state;
  }

  /** Brings into view where the vertices and pins are now. */
  fit(): void {
    this.canvas.fit();
  }

  /** Radians. */
  orbit(azimuth: number, polar: number): void {
    this.canvas.orbit(azimuth, polar);
  }

  /** Nearer by a factor over 1. */
  zoom(factor: number): void {
    this.canvas.zoom(factor);
  }

  /** CSS pixels of the canvas at which a view shows a vertex; null when it is behind the camera or the view hidden. */
  projectToScreen(vertex: number, name: ViewName): ScreenPoint | null {
    return this.canvas.projectToScreen(vertex, name);
  }

  dispose(): void {
    this.outgoing?.dispose();
    this.content?.dispose();
    this.canvas.dispose();
  }

  private picture(): Picture | null {
    const { content, staged } = this;
    if (!content || staged?.frame.p.length !== content.V.length) return null;
    const { p, pinned, targets } = staged.frame;
    return {
      V: content.V,
      typicalRestLength: content.typicalRestLength,
      p,
      pinned,
      targets,
      poke: null,
      view: (name) => content.views[name as ViewName],
      refresh: (pixelsPerMetre) => {
        const legend = content.refresh(staged, this.options, pixelsPerMetre);
        if (legend !== this.legend) this.callbacks.onLegend(legend);
        this.legend = legend;
      },
    };
  }
}
