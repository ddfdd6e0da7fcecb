import type { Ink, Layer } from './ink.ts';
import { joining } from './segment_ends.ts';
import { type SegmentStyle, Segments } from './segments.ts';
import { Table } from './table.ts';

/** Segments between points of their own: one line through all of them unless pairs are given. */
export class Lines {
  readonly segments: Segments;
  private readonly points = new Table(3);
  private readonly pairs = new Table(2);

  constructor(ink: Ink, layer: Layer, capacity: number) {
    this.segments = new Segments(ink, layer, capacity, joining(this.pairs, this.points, this.points));
    this.segments.mesh.visible = false;
  }

  get mesh() {
    return this.segments.mesh;
  }

  setStyle(style: SegmentStyle): void {
    this.segments.setStyle(style);
  }

  /** `points` #×3, m; null: nothing is shown. `pairs` #segments×2: rows of it. */
  set(points: ArrayLike<number> | null, pairs: ArrayLike<number> = points ? oneLine(points.length / 3) : []): void {
    this.mesh.visible = points !== null && pairs.length > 0;
    if (!points || pairs.length === 0) return;
    this.points.set(points);
    this.pairs.set(pairs);
    this.segments.show(0, pairs.length / 2);
  }

  dispose(): void {
    this.segments.dispose();
    this.points.dispose();
    this.pairs.dispose();
  }
}

function oneLine(points: number): Float32Array {
  return Float32Array.from({ length: 2 * Math.max(0, points - 1) }, (_, at) => Math.ceil(at / 2));
}
