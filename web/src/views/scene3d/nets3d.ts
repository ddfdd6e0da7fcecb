import type { Camera } from '../../app/state.ts';
import type { Rectangle } from '../../lib/rectangle.ts';
import { Canvas3D, type Picture } from './canvas3d.ts';
import { neighbourTowards } from './neighbour_towards.ts';
import { NetsContent, type NetsFrame, type NetsOptions } from './nets_content.ts';
import { lightPalette } from './palette.ts';
import { type Grip, pullOn } from './pull.ts';
import type { CanvasCallbacks, Scene3DModel, ScreenPoint } from './types.ts';

/** Where a net's view shows the handle of the pull, CSS pixels of that view, and what pulls it there, N. */
interface ShownPull extends ScreenPoint {
  force: number;
}

const unmarked = new Int32Array();

/** Several nets of one scene, a view each, as variants of one simulation make them. It draws when `render()` is called and never by itself. */
export class Nets3D {
  private readonly canvas: Canvas3D;
  private readonly callbacks: CanvasCallbacks;
  private content: NetsContent | null = null;
  private frame: NetsFrame | null = null;
  private viewports: readonly Rectangle[] = [];
  private marked: Int32Array = unmarked;
  private options: NetsOptions = {
    showSprings: true,
    showSurface: true,
    poke: null,
    pull: null,
    palette: lightPalette,
  };

  constructor(canvas: HTMLCanvasElement, callbacks: CanvasCallbacks) {
    this.callbacks = callbacks;
    const marking = { ...callbacks, onMark: (vertices: Int32Array | null) => this.mark(vertices) };
    this.canvas = new Canvas3D(canvas, marking, () => this.picture());
  }

  /** Replaces the scene, of which `count` nets will be shown. */
  setScene(model: Scene3DModel, count: number): void {
    this.content?.dispose();
    this.content = new NetsContent(this.canvas, model, count, () => this.callbacks.onInvalidate());
    this.marked = unmarked;
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
    this.viewports = rectangles;
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

  /** Vertices that a poke would take hold of. */
  mark(vertices: Int32Array | null): void {
    if (!vertices && this.marked.length === 0) return;
    this.marked = vertices ?? unmarked;
    this.callbacks.onInvalidate();
  }

  /** Where the first net's view shows a vertex or, when that is outside, the nearest place in it: what stands for a vertex must not lie over other things. */
  placeInView(vertex: number): ScreenPoint | null {
    const place = this.projectToScreen(vertex, 0);
    const [view] = this.viewports;
    if (!place || !view) return null;
    return { x: within(place.x, view.x, view.width), y: within(place.y, view.y, view.height) };
  }

  /** Of each net; null without a pull, or where it is behind the camera. */
  shownPulls(): readonly (ShownPull | null)[] {
    const { frame, viewports } = this;
    const { pull } = this.options;
    return viewports.map(({ x, y }, net) => {
      if (!pull || !frame || !this.picture()) return null;
      const { handle, force } = pullOn(pull, frame.nets[net]);
      const place = this.canvas.projectPoint(handle, String(net));
      return place && { x: place.x - x, y: place.y - y, force };
    });
  }

  /** What a poke at a vertex of the first net takes hold of; null when nothing there can move. */
  gripAt(vertex: number): Grip | null {
    const { content, frame, options } = this;
    if (!content || !frame || !options.poke) return null;
    const p = frame.nets[0];
    return content.poking.grip(content.poking.onVertex(vertex, p), p, frame.pinned, options.poke.radius);
  }

  /** Where pokes by keyboard begin; null when nothing can move. */
  firstVertex(): number | null {
    return this.content && this.frame && this.content.poking.first(this.frame.pinned);
  }

  /** The neighbour in a direction (to the right and up) on the screen, as the first net's view shows it; null when there is none. */
  vertexTowards(vertex: number, direction: readonly [number, number]): number | null {
    const here = this.projectToScreen(vertex, 0);
    if (!here || !this.content) return null;
    const fixed = new Set(this.frame?.pinned);
    const places = new Map<number, ScreenPoint>();
    for (const other of this.content.poking.neighboursOf(vertex)) {
      const place = fixed.has(other) ? null : this.projectToScreen(other, 0);
      if (place) places.set(other, place);
    }
    return neighbourTowards(here, places, direction);
  }

  dispose(): void {
    this.content?.dispose();
    this.canvas.dispose();
  }

  private picture(): Picture | null {
    const { content, frame } = this;
    if (!content || !frame || frame.nets.length !== content.views.length) return null;
    if (frame.nets.some((p) => p.length !== content.V.length)) return null;
    const { poke } = this.options;
    return {
      V: content.V,
      typicalRestLength: content.typicalRestLength,
      p: frame.nets[0],
      pinned: frame.pinned,
      targets: frame.targets,
      poke: poke && { ...poke, poking: content.poking },
      view: (name) => content.views[Number(name)],
      refresh: (pixelsPerMetre) => content.refresh(frame, this.options, this.marked, pixelsPerMetre),
    };
  }
}

/** CSS pixels: half of what stands for a vertex. */
const halfHandle = 12;

function within(place: number, from: number, length: number): number {
  return Math.max(from + halfHandle, Math.min(from + length - halfHandle, place));
}
