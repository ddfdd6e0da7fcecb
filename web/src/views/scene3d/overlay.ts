import { Group } from 'three';
import type { Ink } from './ink.ts';
import { Marks } from './marks.ts';
import type { Palette } from './palette.ts';
import { type SegmentStyle, Segments } from './segments.ts';
import { segmentStride } from './spring_segments.ts';
import type { Strokes } from './strokes.ts';
import type { Scene3DFrame } from './types.ts';

/** A spring or a vertex to point out; both or neither may be. */
export interface Highlighted {
  spring: number | null;
  vertex: number | null;
}

/** CSS pixels: dashes of a leash, and how far a vertex must be from where its pin holds it for the leash to be drawn. */
const leash = { width: 1.25, dash: 3, shortest: 4 };

/** What lies over a view's springs: the pins, what is selected and what the pointer rests on. */
export class Overlay {
  readonly group = new Group();
  private readonly pins: Marks;
  /** From each pinned vertex to where its pin will pull it. */
  private readonly leashes: Segments;
  private readonly selected: Highlight;
  private readonly hovered: Highlight;

  constructor(ink: Ink, vertexCount: number) {
    this.pins = new Marks(ink, vertexCount, 'diamond', 'pin');
    this.leashes = new Segments(ink, vertexCount, 'arrow');
    this.hovered = new Highlight(ink);
    this.selected = new Highlight(ink);
    this.group.add(this.hovered.group, this.selected.group, this.leashes.mesh, this.pins.mesh);
  }

  /** `spring`: how this view draws its springs. */
  setStyle(palette: Palette, strokes: Strokes, spring: SegmentStyle): void {
    const { background, pin } = palette;
    this.pins.setStyle({ radius: strokes.pin, halo: strokes.pinHalo, colour: pin, haloColour: background });
    this.leashes.setStyle(leash);
    this.leashes.fill(pin);
    this.selected.setStyle(palette, strokes, { ...spring, width: spring.width + 1 }, 3);
    this.hovered.setStyle(palette, strokes, spring, 1.5);
  }

  /** `segments` #E×8 and `points` #V×3 as drawn in this view. */
  update(
    { pinned, targets }: Scene3DFrame,
    segments: Float32Array,
    points: Float64Array,
    selected: Highlighted,
    hovered: Highlighted,
  ): void {
    this.pins.moveTo(targets);
    pinned.forEach((v, row) => {
      for (let c = 0; c < 3; c++) {
        this.leashes.data[segmentStride * row + c] = points[3 * v + c];
        this.leashes.data[segmentStride * row + 4 + c] = targets[3 * row + c];
      }
    });
    this.leashes.commit(pinned.length);
    this.selected.update(segments, points, selected);
    this.hovered.update(segments, points, hovered);
  }

  dispose(): void {
    for (const part of [this.pins, this.leashes, this.selected, this.hovered]) part.dispose();
  }
}

class Highlight {
  readonly group = new Group();
  private readonly spring: Segments;
  private readonly ring: Marks;

  constructor(ink: Ink) {
    this.spring = new Segments(ink, 1, 'highlight');
    this.ring = new Marks(ink, 1, 'ring', 'highlight');
    this.group.add(this.spring.mesh, this.ring.mesh);
  }

  /** `weight`: CSS pixels of the glow. */
  setStyle({ selected, glow }: Palette, strokes: Strokes, spring: SegmentStyle, weight: number): void {
    this.spring.setStyle({ ...spring, halo: weight, haloColour: glow });
    this.spring.fill(selected);
    this.ring.setStyle({ radius: strokes.vertex + 3 + weight, halo: weight, colour: selected, haloColour: glow });
  }

  update(segments: Float32Array, points: Float64Array, { spring, vertex }: Highlighted): void {
    this.spring.mesh.visible = spring !== null;
    if (spring !== null) {
      const { data } = this.spring;
      const row = segmentStride * spring;
      data.set(segments.subarray(row, row + 3));
      data.set(segments.subarray(row + 4, row + 7), 4);
      this.spring.commit();
    }
    this.ring.mesh.visible = vertex !== null;
    if (vertex !== null) {
      this.ring.moveTo(points.subarray(3 * vertex, 3 * vertex + 3));
    }
  }

  dispose(): void {
    this.spring.dispose();
    this.ring.dispose();
  }
}
