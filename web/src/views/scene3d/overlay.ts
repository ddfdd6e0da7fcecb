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

/** What lies over a view's springs: the pins, what is selected and what the pointer rests on. */
export class Overlay {
  readonly group = new Group();
  private readonly pins: Marks;
  private readonly selected: Highlight;
  private readonly hovered: Highlight;

  constructor(ink: Ink, vertexCount: number) {
    this.pins = new Marks(ink, vertexCount, 'diamond', 'topmost');
    this.hovered = new Highlight(ink);
    this.selected = new Highlight(ink);
    this.group.add(this.hovered.group, this.selected.group, this.pins.mesh);
  }

  /** `spring`: how this view draws its springs. */
  setStyle(palette: Palette, strokes: Strokes, spring: SegmentStyle): void {
    const { background, pin } = palette;
    this.pins.setStyle({ radius: strokes.pin, halo: strokes.pinHalo, colour: pin, haloColour: background });
    this.selected.setStyle(palette, strokes, spring, 3);
    this.hovered.setStyle(palette, strokes, spring, 1.5);
  }

  /**
   * `segments` #E×8 and `points` #V×3 as drawn in this view; `pieces` #E×8 as in the local view, whose colours a spring keeps in
   * both, so that one sees it is the same.
   */
  update(
    frame: Scene3DFrame,
    segments: Float32Array,
    pieces: Float32Array,
    points: Float64Array,
    selected: Highlighted,
    hovered: Highlighted,
  ): void {
    this.pins.moveTo(frame.targets);
    this.selected.update(segments, pieces, points, selected);
    this.hovered.update(segments, pieces, points, hovered);
  }

  dispose(): void {
    for (const part of [this.pins, this.selected, this.hovered]) part.dispose();
  }
}

class Highlight {
  readonly group = new Group();
  private readonly spring: Segments;
  private readonly ring: Marks;

  constructor(ink: Ink) {
    this.spring = new Segments(ink, 1, 'above');
    this.ring = new Marks(ink, 1, 'ring', 'above');
    this.group.add(this.spring.mesh, this.ring.mesh);
  }

  setStyle({ selected, background }: Palette, strokes: Strokes, spring: SegmentStyle, weight: number): void {
    this.spring.setStyle({ ...spring, width: Math.max(2.5, spring.width), halo: weight, haloColour: selected });
    this.ring.setStyle({ radius: strokes.vertex + 3 + weight, halo: 1, colour: selected, haloColour: background });
  }

  update(segments: Float32Array, pieces: Float32Array, points: Float64Array, { spring, vertex }: Highlighted): void {
    this.spring.mesh.visible = spring !== null;
    if (spring !== null) {
      this.spring.data.set(segments.subarray(segmentStride * spring, segmentStride * (spring + 1)));
      this.spring.data[3] = pieces[segmentStride * spring + 3];
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
