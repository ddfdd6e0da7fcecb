import { Group } from 'three';
import type { Pull } from '../../solver/protocol.ts';
import type { Ink } from './ink.ts';
import { Marks } from './marks.ts';
import type { Palette } from './palette.ts';
import { arrowTip, pullOn } from './pull.ts';
import { joining } from './segment_ends.ts';
import { Segments } from './segments.ts';
import type { Strokes } from './strokes.ts';
import { Table } from './table.ts';

/** CSS pixels. */
const arrow = { width: 3, head: 13, shortest: 3, halo: 1.5 };
const handle = { radius: 15, halo: 1.5 };
const leastDot = 2;

/** In one net: the vertices that a pull takes hold of, and its force as an arrow from their middle to the handle. */
export class PullMarks {
  readonly group = new Group();
  private readonly places = new Table(3);
  private readonly dots: Marks;
  /** A row each: the arrow's ends, and the handle. */
  private readonly tails = new Table(3);
  private readonly tips = new Table(3);
  private readonly handles = new Table(3);
  private readonly pair = new Table(2);
  private readonly arrow: Segments;
  private readonly handle: Marks;

  constructor(ink: Ink, vertexCount: number) {
    this.pair.set([0, 0]);
    this.dots = new Marks(ink, 'net', vertexCount, 'disc', this.places);
    this.arrow = new Segments(ink, 'arrow', 1, joining(this.pair, this.tails, this.tips));
    this.handle = new Marks(ink, 'pin', 1, 'ring', this.handles);
    this.group.add(this.dots.mesh, this.arrow.mesh, this.handle.mesh);
  }

  setStyle({ pull, background }: Palette, strokes: Strokes): void {
    const radius = Math.max(leastDot, strokes.vertex);
    this.dots.setStyle({ radius, halo: 1, colour: pull, haloColour: background });
    this.arrow.setStyle({ ...arrow, colour: pull, haloColour: background });
    this.handle.setStyle({ ...handle, colour: pull, haloColour: background });
  }

  /** `points` #V×3, metres. */
  show(vertices: Int32Array, pull: Pull | null, points: Float64Array, pixelsPerMetre: number): void {
    this.dots.mesh.visible = vertices.length > 0;
    this.arrow.mesh.visible = pull !== null;
    this.handle.mesh.visible = pull !== null;
    if (vertices.length > 0) this.placeDots(vertices, points);
    if (!pull) return;
    const shown = pullOn(pull, points);
    this.tails.set(shown.centre);
    this.tips.set(arrowTip(shown, pixelsPerMetre));
    this.handles.set(shown.handle);
  }

  private placeDots(vertices: Int32Array, points: Float64Array): void {
    const places = this.places.write(vertices.length);
    vertices.forEach((v, at) => {
      places.set(points.subarray(3 * v, 3 * v + 3), 3 * at);
    });
    this.dots.show(0, vertices.length);
  }

  dispose(): void {
    for (const part of [this.dots, this.arrow, this.handle]) part.dispose();
    for (const table of [this.places, this.tails, this.tips, this.handles, this.pair]) table.dispose();
  }
}
