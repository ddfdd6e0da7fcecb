import type { Ink, Layer } from './ink.ts';
import { Marks } from './marks.ts';
import { Table } from './table.ts';

/** Marks at points of their own. */
export class Dots {
  readonly marks: Marks;
  private readonly points = new Table(3);

  constructor(ink: Ink, layer: Layer, capacity: number, shape: ConstructorParameters<typeof Marks>[3]) {
    this.marks = new Marks(ink, layer, capacity, shape, this.points);
    this.marks.mesh.visible = false;
  }

  get mesh() {
    return this.marks.mesh;
  }

  setStyle(style: Parameters<Marks['setStyle']>[0]): void {
    this.marks.setStyle(style);
  }

  /** #×3, m; null: none. */
  set(points: ArrayLike<number> | null): void {
    this.mesh.visible = points !== null && points.length > 0;
    if (!points || points.length === 0) return;
    this.points.set(points);
    this.marks.show(0, points.length / 3);
  }

  dispose(): void {
    this.marks.dispose();
    this.points.dispose();
  }
}
