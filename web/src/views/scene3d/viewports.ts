import type { Rectangle, ViewName } from './types.ts';

export interface Viewport {
  name: ViewName;
  rectangle: Rectangle;
}

/** Where the two views lie on the canvas. What has no area is not shown. */
export class Viewports {
  readonly shown: readonly Viewport[];

  constructor(local: Rectangle | null, global: Rectangle | null) {
    const all = [
      { name: 'local', rectangle: local },
      { name: 'global', rectangle: global },
    ] as const;
    this.shown = all.flatMap(({ name, rectangle }) => {
      return rectangle && rectangle.width > 0 && rectangle.height > 0 ? [{ name, rectangle }] : [];
    });
  }

  named(name: ViewName): Viewport | undefined {
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
