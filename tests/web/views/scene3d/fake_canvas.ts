/** As much of a canvas as gestures need: 400 × 300 CSS pixels, its corner at (100, 50) of the page. */
export class FakeCanvas extends EventTarget {
  readonly style = { touchAction: '', cursor: '' };
  readonly clientHeight = 300;
  readonly captured: number[] = [];

  getBoundingClientRect() {
    return { left: 100, top: 50 };
  }

  setPointerCapture(pointerId: number) {
    this.captured.push(pointerId);
  }

  /** Sends an event at a place of the canvas. */
  send(type: string, x: number, y: number, more: Partial<PointerEvent & WheelEvent> = {}): Event {
    const defaults = { pointerId: 1, pointerType: 'mouse', button: 0, buttons: 1, shiftKey: false, ctrlKey: false };
    const event = new Event(type, { cancelable: true });
    Object.assign(event, defaults, { clientX: 100 + x, clientY: 50 + y, DOM_DELTA_LINE: 1, deltaMode: 0 }, more);
    this.dispatchEvent(event);
    return event;
  }

  asCanvas(): HTMLCanvasElement {
    return this as unknown as HTMLCanvasElement;
  }
}
