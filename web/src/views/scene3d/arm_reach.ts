import { Group } from 'three';
import { circleOnFloor, reachOnFloor } from './arm_geometry.ts';
import type { ArmPalette } from './arm_palette.ts';
import type { ArmPicture } from './arm_picture.ts';
import type { Ink } from './ink.ts';
import { Lines } from './lines.ts';

const pieces = 96;

/** Where on the floor the arm's reach ends and, if it has a link longer than all others together, where it begins. */
export class ArmReach {
  readonly group = new Group();
  private readonly outer: Lines;
  private readonly inner: Lines;

  constructor(ink: Ink) {
    this.outer = new Lines(ink, 'net', pieces);
    this.inner = new Lines(ink, 'net', pieces);
    this.group.add(this.outer.mesh, this.inner.mesh);
  }

  setStyle({ axis }: ArmPalette): void {
    for (const circle of [this.outer, this.inner]) circle.setStyle({ width: 1.5, colour: axis });
  }

  show({ links, root }: Pick<ArmPicture, 'links' | 'root'>): void {
    const { outer, inner } = reachOnFloor(links, root[1]);
    const circle = (radius: number | null) =>
      radius === null ? null : circleOnFloor(root[0], root[2], radius, pieces);
    this.outer.set(circle(outer));
    this.inner.set(circle(inner));
  }

  dispose(): void {
    this.outer.dispose();
    this.inner.dispose();
  }
}
