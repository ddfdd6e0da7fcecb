import { Group } from 'three';
import type { Selection } from '../../app/state.ts';
import type { Glsl } from './glsl.ts';
import type { Ink } from './ink.ts';
import { Marks } from './marks.ts';
import type { NetTables } from './net_tables.ts';
import type { Palette } from './palette.ts';
import { joining } from './segment_ends.ts';
import { type SegmentStyle, Segments } from './segments.ts';
import type { Strokes } from './strokes.ts';
import type { Table } from './table.ts';

/** CSS pixels: dashes of a leash, and how far a vertex must be from where its pin holds it for the leash to be drawn. */
const leash = { width: 1.25, dash: 3, shortest: 4 };

/** What lies over a view's springs: the pins, what is selected and what is pointed at. */
export class Overlay {
  readonly group = new Group();
  private readonly pins: Marks;
  /** From each pinned vertex to where its pin will pull it. */
  private readonly leashes: Segments;
  private readonly selected: Highlight;
  private readonly pointedAt: Highlight;

  /** `points` #V×3 and `springEnds` as this view draws them. */
  constructor(ink: Ink, vertexCount: number, tables: NetTables, points: Table, springEnds: Glsl) {
    this.pins = new Marks(ink, 'pin', vertexCount, 'diamond', tables.targets);
    this.leashes = new Segments(ink, 'arrow', vertexCount, joining(tables.pins, points, tables.targets));
    this.pointedAt = new Highlight(ink, points, springEnds);
    this.selected = new Highlight(ink, points, springEnds);
    this.group.add(this.pointedAt.group, this.selected.group, this.leashes.mesh, this.pins.mesh);
  }

  /** `spring`: how this view draws its springs. */
  setStyle(palette: Palette, strokes: Strokes, spring: SegmentStyle): void {
    const { background, pin } = palette;
    this.pins.setStyle({ radius: strokes.pin, halo: strokes.pinHalo, colour: pin, haloColour: background });
    this.leashes.setStyle({ ...leash, colour: pin });
    this.selected.setStyle(palette, strokes, { ...spring, width: spring.width + 1 }, 3);
    this.pointedAt.setStyle(palette, strokes, spring, 1.5);
  }

  /** Whether pins are hidden by what is in front of them. */
  hidePinsBehind(hidden: boolean): void {
    this.pins.hideBehind(hidden);
    this.leashes.hideBehind(hidden);
  }

  show(pinCount: number, selected: Selection, pointedAt: Selection): void {
    this.pins.show(0, pinCount);
    this.leashes.show(0, pinCount);
    this.selected.show(selected);
    this.pointedAt.show(pointedAt);
  }

  dispose(): void {
    for (const part of [this.pins, this.leashes, this.selected, this.pointedAt]) part.dispose();
  }
}

class Highlight {
  readonly group = new Group();
  private readonly spring: Segments;
  private readonly ring: Marks;

  constructor(ink: Ink, points: Table, springEnds: Glsl) {
    this.spring = new Segments(ink, 'highlight', 1, springEnds);
    this.ring = new Marks(ink, 'highlight', 1, 'ring', points);
    this.group.add(this.spring.mesh, this.ring.mesh);
  }

  /** `weight`: CSS pixels of the glow. */
  setStyle({ selected, glow }: Palette, strokes: Strokes, spring: SegmentStyle, weight: number): void {
    this.spring.setStyle({ ...spring, colour: selected, halo: weight, haloColour: glow });
    this.ring.setStyle({ radius: strokes.vertex + 3 + weight, halo: weight, colour: selected, haloColour: glow });
  }

  show({ spring, vertex }: Selection): void {
    this.spring.mesh.visible = spring !== null;
    this.ring.mesh.visible = vertex !== null;
    if (spring !== null) this.spring.show(spring, 1);
    if (vertex !== null) this.ring.show(vertex, 1);
  }

  dispose(): void {
    this.spring.dispose();
    this.ring.dispose();
  }
}
