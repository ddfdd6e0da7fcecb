import type { Rectangle } from '../../lib/rectangle.ts';

export interface Viewport {
  name: string;
  rectangle: Rectangle;
}

/** Where the views lie on the canvas. What has no area is not shown. */
export class Viewports {
  readonly shown: readonly Viewport[];

  constructor(all: readonly Viewport[]) {
    this.shown = all.filter(({ rectangle: { width, height } }) => width > 0 && height > 0);
  }

  named(name: string): Viewport | undefined {
    return this.shown.find((viewport) => viewport.name === name);
  }

  /** At a place of the canvas, CSS pixels. */
  at(x: number, y: number): Viewport | undefined {
    return this.shown.find(({ rectangle: r }) => x >= r.x && y >= r.y && x < r.x + r.width && y < r.y + r.height);
  }

  /** CSS pixels; views of one camera show things in proportion to their heights. */
  get height(): number {
    return Math.max(1, ...this.shown.map(({ rectangle }) => rectangle.height));
  }

  get narrowestAspect(): number {
    return Math.min(...this.shown.map(({ rectangle }) => rectangle.width / rectangle.height));
  }
}
