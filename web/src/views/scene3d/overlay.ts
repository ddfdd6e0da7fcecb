import { Group } from 'three';
import type { Ink } from './ink.ts';
import { Marks } from './marks.ts';
import type { Palette } from './palette.ts';
import { Segments } from './segments.ts';
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
    this.pins = new Marks(ink, vertexCount, 'diamond', 'above');
    this.hovered = new Highlight(ink);
    this.selected = new Highlight(ink);
    this.group.add(this.hovered.group, this.selected.group, this.pins.mesh);
  }

  setStyle(palette: Palette, strokes: Strokes): void {
    const { background, pin } = palette;
    this.pins.setStyle({ radius: strokes.pin, halo: 1.5, colour: pin, haloColour: background });
    this.selected.setStyle(palette, strokes, 3);
    this.hovered.setStyle(palette, strokes, 1.5);
  }

  /** `segments` as drawn in this view, `points` #V×3 its vertices. */
  update(
    frame: Scene3DFrame,
    segments: Segments,
    points: Float64Array,
    selected: Highlighted,
    hovered: Highlighted,
  ): void {
    this.pins.centres.set(frame.targets);
    this.pins.mesh.geometry.instanceCount = frame.pinned.length;
    this.pins.commit();
    this.selected.update(segments, points, selected);
    this.hovered.update(segments, points, hovered);
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

  setStyle({ selected, background }: Palette, strokes: Strokes, weight: number): void {
    this.spring.setStyle({ width: strokes.selected, dot: strokes.pieceDot, head: 0, halo: weight }, selected);
    this.ring.setStyle({ radius: strokes.vertex + 3 + weight, halo: 1, colour: selected, haloColour: background });
  }

  update(segments: Segments, points: Float64Array, { spring, vertex }: Highlighted): void {
    this.spring.mesh.visible = spring !== null;
    if (spring !== null) {
      this.spring.ends.set(segments.ends.subarray(6 * spring, 6 * spring + 6));
      this.spring.colours.set(segments.colours.subarray(4 * spring, 4 * spring + 4));
      this.spring.commitEnds();
      this.spring.commitColours();
    }
    this.ring.mesh.visible = vertex !== null;
    if (vertex !== null) {
      this.ring.centres.set(points.subarray(3 * vertex, 3 * vertex + 3));
      this.ring.commit();
    }
  }

  dispose(): void {
    this.spring.dispose();
    this.ring.dispose();
  }
}
