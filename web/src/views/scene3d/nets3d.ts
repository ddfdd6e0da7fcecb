import type { Camera, Selection } from '../../app/state.ts';
import type { Rectangle } from '../../lib/rectangle.ts';
import { Canvas3D, type Picture } from './canvas3d.ts';
import { quantile } from './exaggeration.ts';
import { GlobalView } from './global_view.ts';
import { NetTables } from './net_tables.ts';
import { lightPalette, type Palette } from './palette.ts';
import { stageOf } from './stages.ts';
import { strokesFor } from './strokes.ts';
import type { CanvasCallbacks, Scene3DModel, ScreenPoint } from './types.ts';

/** Where the nets are; nobody changes the arrays. */
export interface NetsFrame {
  /** #V×3 each, metres: one for every view. */
  nets: readonly Float64Array[];
  /** #pinned, and #pinned×3, metres. */
  pinned: Int32Array;
  targets: Float64Array;
}

export interface NetsOptions {
  showSprings: boolean;
  showSurface: boolean;
  palette: Palette;
}

const nothing: Selection = { spring: null, vertex: null };

/** Several nets of one scene, a view each, as variants of one simulation make them. It draws when `render()` is called and never by itself. */
export class Nets3D {
  private readonly canvas: Canvas3D;
  private readonly callbacks: CanvasCallbacks;
  private content: NetsContent | null = null;
  private frame: NetsFrame | null = null;
  private options: NetsOptions = { showSprings: true, showSurface: true, palette: lightPalette };

  constructor(canvas: HTMLCanvasElement, callbacks: CanvasCallbacks) {
    this.callbacks = callbacks;
    this.canvas = new Canvas3D(canvas, callbacks, () => this.picture());
  }

  /** Replaces the scene, of which `count` nets will be shown. */
  setScene(model: Scene3DModel, count: number): void {
    this.content?.dispose();
    this.content = new NetsContent(this.canvas, model, count, () => this.callbacks.onInvalidate());
    this.canvas.begin(model.V);
  }

  /** Scene and frame may be set in either order: nothing is drawn while they do not fit. */
  setFrame(frame: NetsFrame): void {
    this.frame = frame;
    this.callbacks.onInvalidate();
  }

  setOptions(options: Partial<NetsOptions>): void {
    this.options = { ...this.options, ...options };
    this.callbacks.onInvalidate();
  }

  /** Where each net's view lies on the canvas. To be called whenever the canvas changes its size, too. */
  setViewports(rectangles: readonly Rectangle[]): void {
    this.canvas.setViewports(rectangles.map((rectangle, net) => ({ name: String(net), rectangle })));
  }

  render(): void {
    this.canvas.render(this.options.palette.background);
  }

  get camera(): Camera {
    return this.canvas.camera;
  }

  /** Brings into view where the first net and the pins are now. */
  fit(): void {
    this.canvas.fit();
  }

  /** CSS pixels of the canvas at which a net's view shows a vertex; null when it is behind the camera. */
  projectToScreen(vertex: number, net: number): ScreenPoint | null {
    return this.canvas.projectToScreen(vertex, String(net));
  }

  dispose(): void {
    this.content?.dispose();
    this.canvas.dispose();
  }

  private picture(): Picture | null {
    const { content, frame } = this;
    if (!content || !frame || frame.nets.length !== content.views.length) return null;
    if (frame.nets.some((p) => p.length !== content.V.length)) return null;
    return {
      V: content.V,
      typicalRestLength: content.typicalRestLength,
      p: frame.nets[0],
      pinned: frame.pinned,
      targets: frame.targets,
      background: this.options.palette.background,
      view: (name) => content.views[Number(name)],
      refresh: (pixelsPerMetre) => content.refresh(frame, this.options, pixelsPerMetre),
    };
  }
}

/** Everything allocated for one scene. */
class NetsContent {
  readonly views: readonly GlobalView[];
  /** Metres: the median rest length. */
  readonly typicalRestLength: number;
  /** #V×3, metres. */
  readonly V: Float64Array;
  private readonly tables: NetTables;
  private shown: NetsFrame | null = null;

  constructor({ ink }: Canvas3D, model: Scene3DModel, count: number, onTexture: () => void) {
    this.V = model.V;
    this.tables = new NetTables(model.E);
    this.views = Array.from({ length: count }, () => new GlobalView(ink, model, this.tables, onTexture));
    this.typicalRestLength = quantile(model.r.length, (e) => model.r[e], 0.5);
  }

  refresh(frame: NetsFrame, { palette, showSprings, showSurface }: NetsOptions, pixelsPerMetre: number): void {
    const strokes = strokesFor(this.typicalRestLength * pixelsPerMetre);
    const { pinned, targets } = frame;
    if (frame !== this.shown) this.tables.setPins(frame);
    this.views.forEach((view, net) => {
      const p = frame.nets[net];
      const still = { phase: 'accept', p, pBefore: p, d: null, prediction: p, pinned, targets } as const;
      if (frame !== this.shown) view.update(stageOf(still, 1), null);
      view.setStyle(palette, strokes, { showSprings, showSurface, litSprings: false, litVertices: false });
      view.overlay.show(pinned.length, nothing, nothing);
    });
    this.shown = frame;
  }

  dispose(): void {
    for (const view of this.views) view.dispose();
    this.tables.dispose();
  }
}
