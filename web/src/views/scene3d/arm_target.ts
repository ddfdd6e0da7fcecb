import { Group } from 'three';
import type { Point3 } from '../../app/kinematics.ts';
import type { ArmPalette } from './arm_palette.ts';
import type { Ink } from './ink.ts';
import { Marks } from './marks.ts';
import { joining } from './segment_ends.ts';
import { Segments } from './segments.ts';
import { Table } from './table.ts';

/** The target, its shadow on the floor below or above it, and a line between the two that makes its depth seen. */
export class ArmTargetMarks {
  readonly group = new Group();
  /** The target and its shadow. */
  private readonly points = new Table(3);
  private readonly pair = new Table(2);
  private readonly plumb: Segments;
  private readonly shadow: Marks;
  private readonly ring: Marks;
  private readonly dot: Marks;

  constructor(ink: Ink) {
    this.pair.set([0, 1]);
    this.plumb = new Segments(ink, 'net', 1, joining(this.pair, this.points, this.points));
    this.shadow = new Marks(ink, 'net', 1, 'disc', this.points);
    this.ring = new Marks(ink, 'pin', 1, 'ring', this.points);
    this.dot = new Marks(ink, 'pin', 1, 'disc', this.points);
    this.shadow.show(1, 1);
    for (const { mesh } of [this.plumb, this.shadow, this.ring, this.dot]) this.group.add(mesh);
  }

  /** CSS pixels. */
  setStyle({ target: colour, background }: ArmPalette): void {
    const halo = { halo: 1.5, haloColour: background };
    this.plumb.setStyle({ width: 1.25, colour });
    this.shadow.setStyle({ radius: 5, ...halo, colour });
    this.ring.setStyle({ radius: 11, ...halo, colour });
    this.dot.setStyle({ radius: 4, ...halo, colour });
  }

  show([x, y, z]: Point3): void {
    this.points.set([x, y, z, x, 0, z]);
  }

  dispose(): void {
    for (const part of [this.plumb, this.shadow, this.ring, this.dot, this.points, this.pair]) part.dispose();
  }
}
