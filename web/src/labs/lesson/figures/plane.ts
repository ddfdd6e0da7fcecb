import type { Window } from './planar_scenes.ts';

/** CSS pixels, y downwards. */
export type Place = readonly [x: number, y: number];

/** How a picture of a given width shows a part of the plane z = 0. */
export class Plane {
  readonly height: number;
  private readonly window: Window;
  /** px/m. */
  private readonly scale: number;

  constructor(window: Window, width: number) {
    this.window = window;
    this.scale = width / (window.right - window.left);
    this.height = this.scale * (window.top - window.bottom);
  }

  /** Where row i of #×3 positions is drawn. */
  place(positions: ArrayLike<number>, i: number): Place {
    const x = positions[3 * i];
    const y = positions[3 * i + 1];
    return [(x - this.window.left) * this.scale, (this.window.top - y) * this.scale];
  }

  /** m: what is drawn there. */
  point([x, y]: Place): [number, number, number] {
    return [this.window.left + x / this.scale, this.window.top - y / this.scale, 0];
  }

  /** px: how long so many metres are drawn. */
  length(metres: number): number {
    return metres * this.scale;
  }
}
