import { Gestures } from '../../lib/gestures.ts';
import { nearestEntry, type Place } from './pattern.ts';
import { SparsityPicture } from './sparsity_picture.ts';
import { margin, type Sparsity } from './types.ts';
import { type Area, fitScale, fitted, panned, placeAt, showing, type Viewport, zoomedAt } from './viewport.ts';

export interface SparsityHandlers {
  /** Where a mouse rests: the cell under it, or the nearest entry where cells are too small to be met. */
  onHover(place: Place | null): void;
  onTap(place: Place): void;
}

/** CSS pixels a cell under which the nearest entry is meant, and how far away that may be. */
const smallest = 6;
/** Factor of one press of a button or key. */
export const zoomStride = 1.5;

/** One matrix under the reader's hands. Draws in the next animation frame, and only when something has changed. */
export class SparsityControl {
  private readonly canvas: HTMLCanvasElement;
  private readonly picture: SparsityPicture;
  private readonly gestures: Gestures;
  private shown: Omit<Sparsity, 'view'> | null = null;
  private view: Viewport | null = null;
  private area: Area = { width: 0, height: 0 };
  private drawing = 0;

  constructor(canvas: HTMLCanvasElement, { onHover, onTap }: SparsityHandlers) {
    this.canvas = canvas;
    this.picture = new SparsityPicture(canvas);
    const pan = (dx: number, dy: number) => this.move((view, shown) => panned(view, dx, dy, shown.pattern, this.area));
    this.gestures = new Gestures(canvas, {
      grab: () => false,
      drag: () => {},
      release: () => {},
      tap: (x, y) => {
        const place = this.placeAt(x, y);
        if (place) onTap(place);
      },
      orbit: pan,
      pan,
      zoom: (factor, x, y) => this.zoomAt(factor, x - margin.left, y - margin.top),
      hover: (at) => onHover(at && this.placeAt(at.x, at.y)),
    });
  }

  /** A matrix of another size is shown whole; one of the same size stays where it is. */
  show(next: Omit<Sparsity, 'view'>): void {
    const { pattern: before } = this.shown ?? {};
    this.shown = next;
    if (before?.rows !== next.pattern.rows || before.columns !== next.pattern.columns) this.view = null;
    this.invalidate();
  }

  /** Takes over the canvas's size on the page. */
  resize(): void {
    const wasWhole = this.isWhole;
    this.area = {
      width: Math.max(1, this.canvas.clientWidth - margin.left - margin.right),
      height: Math.max(1, this.canvas.clientHeight - margin.top - margin.bottom),
    };
    if (wasWhole) this.view = null;
    else this.move((view, { pattern }) => panned(view, 0, 0, pattern, this.area));
    this.invalidate();
  }

  zoom(factor: number): void {
    this.zoomAt(factor, this.area.width / 2, this.area.height / 2);
  }

  /** About a place, which comes into view. */
  zoomTo(factor: number, place: Place): void {
    this.move((view, { pattern }) => {
      const x = (place.column + 0.5 - view.column) * view.scale;
      const y = (place.row + 0.5 - view.row) * view.scale;
      return showing(zoomedAt(view, factor, x, y, pattern, this.area), place, pattern, this.area);
    });
  }

  fit(): void {
    this.view = null;
    this.invalidate();
  }

  reveal(place: Place): void {
    this.move((view, { pattern }) => showing(view, place, pattern, this.area));
  }

  dispose(): void {
    this.gestures.dispose();
    cancelAnimationFrame(this.drawing);
  }

  private zoomAt(factor: number, x: number, y: number): void {
    this.move((view, { pattern }) => zoomedAt(view, factor, x, y, pattern, this.area));
  }

  private move(change: (view: Viewport, shown: Omit<Sparsity, 'view'>) => Viewport): void {
    if (!this.shown || this.area.width === 0) return;
    this.view = change(this.currentView(this.shown), this.shown);
    this.invalidate();
  }

  private currentView({ pattern }: Omit<Sparsity, 'view'>): Viewport {
    this.view ??= fitted(pattern, this.area);
    return this.view;
  }

  private get isWhole(): boolean {
    return !this.shown || !this.view || this.view.scale <= fitScale(this.shown.pattern, this.area);
  }

  private placeAt(x: number, y: number): Place | null {
    if (!this.shown) return null;
    const { pattern } = this.shown;
    const view = this.currentView(this.shown);
    const place = placeAt(view, x - margin.left, y - margin.top, pattern);
    if (!place || view.scale >= smallest) return place;
    return nearestEntry(pattern, place, Math.ceil(smallest / view.scale));
  }

  private invalidate(): void {
    this.drawing ||= requestAnimationFrame(() => {
      this.drawing = 0;
      if (!this.shown || this.area.width === 0) return; // not laid out yet
      const started = performance.now();
      this.picture.render({ ...this.shown, view: this.currentView(this.shown) }, this.area);
      this.canvas.style.touchAction = this.isWhole ? 'pan-y' : 'none'; // a finger on all of it scrolls the page
      this.canvas.dataset.milliseconds = (performance.now() - started).toFixed(2);
    });
  }
}
