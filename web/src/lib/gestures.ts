/** What pointers on an element mean. Places are CSS pixels of the element, movements CSS pixels. */
export interface GestureHandlers {
  /** A press: true when it takes hold of something that can be dragged. */
  grab(x: number, y: number, pointerType: string): boolean;
  drag(x: number, y: number): void;
  /** The held thing is let go; `drag` may never have been called. */
  release(): void;
  tap(x: number, y: number, pointerType: string, shift: boolean): void;
  orbit(dx: number, dy: number): void;
  pan(dx: number, dy: number): void;
  /** Nearer by a factor over 1, about a place. */
  zoom(factor: number, x: number, y: number): void;
  /** A pointer without a button pressed; null when it has left. */
  hover(place: { x: number; y: number } | null): void;
}

interface Finger {
  x: number;
  y: number;
}

/** CSS pixels that a press may wander and still be a tap. */
const tapSlack: Record<string, number> = { mouse: 3, pen: 6, touch: 10 };
/** Pinching a touchpad sends wheel events of a few pixels, a notch of a mouse wheel one of a hundred or more. */
const zoomPerWheelPixel = 0.01;
const mostWheelPixels = 20;
const pixelsPerWheelLine = 16;

/**
 * One finger on something draggable drags it, one elsewhere orbits (or does what its handler makes of that), two move and zoom; a second finger lets go of what the first held.
 * With a mouse the right button (or ctrl) pans, and the wheel with ctrl zooms, as pinching a touchpad does; the wheel alone scrolls the page.
 */
export class Gestures {
  private readonly element: HTMLElement;
  private readonly handlers: GestureHandlers;
  private readonly fingers = new Map<number, Finger>();
  private readonly stop = new AbortController();
  private holding = false;
  /** Where the press began, while it may still become a tap. */
  private press: Finger | null = null;

  constructor(element: HTMLElement, handlers: GestureHandlers) {
    this.element = element;
    this.handlers = handlers;
    element.style.touchAction = 'none'; // or the browser would scroll instead
    const options = { signal: this.stop.signal };
    element.addEventListener('pointerdown', (event) => this.down(event), options);
    element.addEventListener('pointermove', (event) => this.move(event), options);
    element.addEventListener('pointerup', (event) => this.up(event, true), options);
    element.addEventListener('pointercancel', (event) => this.up(event, false), options);
    element.addEventListener('pointerleave', () => this.handlers.hover(null), options);
    element.addEventListener('wheel', (event) => this.wheel(event), { ...options, passive: false });
    element.addEventListener('contextmenu', (event) => event.preventDefault(), options);
  }

  dispose(): void {
    this.stop.abort();
  }

  private place(event: MouseEvent): Finger {
    const bounds = this.element.getBoundingClientRect();
    return { x: event.clientX - bounds.left, y: event.clientY - bounds.top };
  }

  private down(event: PointerEvent): void {
    const finger = this.place(event);
    this.element.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, finger);
    if (this.fingers.size > 1) {
      this.letGo();
      this.press = null;
      return;
    }
    this.handlers.hover(null);
    this.press = event.button === 0 ? finger : null;
    const mayGrab = event.button === 0 && !event.shiftKey && !event.ctrlKey;
    this.holding = mayGrab && this.handlers.grab(finger.x, finger.y, event.pointerType);
  }

  private move(event: PointerEvent): void {
    const now = this.place(event);
    const before = this.fingers.get(event.pointerId);
    if (!before) {
      if (event.pointerType !== 'touch') this.handlers.hover(now);
      return;
    }
    if (this.press && distance(now, this.press) <= (tapSlack[event.pointerType] ?? tapSlack.touch)) return;
    this.press = null;
    const other = [...this.fingers].find(([id]) => id !== event.pointerId)?.[1];
    this.fingers.set(event.pointerId, now);
    const dx = now.x - before.x;
    const dy = now.y - before.y;
    if (this.holding) {
      this.handlers.drag(now.x, now.y);
    } else if (other) {
      this.handlers.pan(dx / 2, dy / 2);
      const factor = distance(now, other) / Math.max(1, distance(before, other));
      this.handlers.zoom(factor, (now.x + other.x) / 2, (now.y + other.y) / 2);
    } else if (event.buttons === 2 || event.ctrlKey) {
      this.handlers.pan(dx, dy);
    } else {
      this.handlers.orbit(dx, dy);
    }
  }

  private up(event: PointerEvent, finished: boolean): void {
    if (!this.fingers.delete(event.pointerId)) return;
    this.letGo();
    if (finished && this.press) this.handlers.tap(this.press.x, this.press.y, event.pointerType, event.shiftKey);
    this.press = null;
  }

  private letGo(): void {
    if (this.holding) this.handlers.release();
    this.holding = false;
  }

  private wheel(event: WheelEvent): void {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault(); // or the browser would enlarge the page
    const pixels = event.deltaY * (event.deltaMode === event.DOM_DELTA_LINE ? pixelsPerWheelLine : 1);
    const { x, y } = this.place(event);
    this.handlers.zoom(
      Math.exp(-zoomPerWheelPixel * Math.max(-mostWheelPixels, Math.min(mostWheelPixels, pixels))),
      x,
      y,
    );
  }
}

function distance(a: Finger, b: Finger): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}
