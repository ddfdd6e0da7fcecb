import { Group } from 'three';
import { kinematicsLimits } from '../../app/kinematics.ts';
import { arcBetween, circleOnFloor, distanceOf, reachOnFloor } from './arm_geometry.ts';
import type { ArmMoment } from './arm_moment.ts';
import type { ArmPalette } from './arm_palette.ts';
import type { ArmPicture } from './arm_picture.ts';
import { Dots } from './dots.ts';
import type { Ink } from './ink.ts';
import { Lines } from './lines.ts';

const mostJoints = kinematicsLimits.links.max + 1;
const circlePieces = 96;
const arcPieces = 24;
/** The arc of an angle: a share of the shorter of its two rays. */
const arcShare = 0.4;

/** Flat marks around the arm: the target and where it stands, the reach, the pose that the search began with, and what has just turned. */
export class ArmMarks {
  readonly group = new Group();
  private readonly parts: (Lines | Dots)[] = [];
  private readonly ghostLinks: Lines;
  private readonly ghostJoints: Dots;
  private readonly outerReach: Lines;
  private readonly innerReach: Lines;
  private readonly plumb: Lines;
  private readonly shadow: Dots;
  private readonly rayBefore: Lines;
  private readonly rayToTarget: Lines;
  private readonly arc: Lines;
  private readonly leash: Lines;
  private readonly leftRoot: Dots;
  private readonly pointed: Dots;
  private readonly ring: Dots;
  private readonly dot: Dots;

  constructor(ink: Ink) {
    const lines = (layer: ConstructorParameters<typeof Lines>[1], capacity: number) =>
      this.add(new Lines(ink, layer, capacity));
    const dots = (...given: [ConstructorParameters<typeof Dots>[1], number, ConstructorParameters<typeof Dots>[3]]) =>
      this.add(new Dots(ink, ...given));
    this.ghostLinks = lines('ghost', mostJoints);
    this.ghostJoints = dots('ghost', mostJoints, 'disc');
    this.outerReach = lines('net', circlePieces);
    this.innerReach = lines('net', circlePieces);
    this.plumb = lines('net', 1);
    this.shadow = dots('net', 1, 'disc');
    this.pointed = dots('highlight', 1, 'ring');
    this.rayBefore = lines('arrow', 1);
    this.rayToTarget = lines('arrow', 1);
    this.arc = lines('arrow', arcPieces);
    this.leash = lines('arrow', 1);
    this.leftRoot = dots('pin', 1, 'ring');
    this.ring = dots('pin', 1, 'ring');
    this.dot = dots('pin', 1, 'disc');
  }

  /** Lengths in CSS pixels. */
  setStyle({ background, ghost, axis, target, effector, turned, pointed, glow, joint }: ArmPalette): void {
    const halo = { halo: 1.5, haloColour: background };
    this.ghostLinks.setStyle({ width: 5, colour: ghost });
    this.ghostJoints.setStyle({ radius: 5, halo: 0, haloColour: background, colour: ghost });
    this.outerReach.setStyle({ width: 1.5, colour: axis });
    this.innerReach.setStyle({ width: 1.5, colour: axis });
    this.plumb.setStyle({ width: 1.25, colour: target });
    this.shadow.setStyle({ radius: 5, halo: 1, haloColour: background, colour: target });
    this.pointed.setStyle({ radius: 14, halo: 3, haloColour: glow, colour: pointed });
    this.rayBefore.setStyle({ width: 1.75, dash: 4, colour: effector, ...halo });
    this.rayToTarget.setStyle({ width: 1.75, dash: 4, colour: target, ...halo });
    this.arc.setStyle({ width: 3, colour: turned });
    this.leash.setStyle({ width: 1.5, dash: 4, colour: joint });
    this.leftRoot.setStyle({ radius: 9, ...halo, colour: joint });
    this.ring.setStyle({ radius: 11, ...halo, colour: target });
    this.dot.setStyle({ radius: 4, ...halo, colour: target });
  }

  show({ x, root, lengths, target, moment, pointedJoint }: ArmPicture): void {
    const { outer, inner } = reachOnFloor(lengths, root[1]);
    const circle = (radius: number | null) => radius && circleOnFloor(root[0], root[2], radius, circlePieces);
    this.outerReach.set(circle(outer) || null);
    this.innerReach.set(circle(inner) || null);
    this.ring.set(target);
    this.dot.set(target);
    const foot = [target[0], 0, target[2]];
    this.shadow.set(foot);
    this.plumb.set([...target, ...foot]);
    this.pointed.set(
      pointedJoint !== null && 3 * pointedJoint < x.length ? x.subarray(3 * pointedJoint, 3 * pointedJoint + 3) : null,
    );
    this.ghostLinks.set(moment?.ghost ?? null);
    this.ghostJoints.set(moment?.ghost ?? null);
    this.showTurn(moment?.turned ?? null, target);
    this.leftRoot.set(moment?.detached ? root : null);
    this.leash.set(moment?.detached ? [...root, ...x.subarray(0, 3)] : null);
  }

  dispose(): void {
    for (const part of this.parts) part.dispose();
  }

  private showTurn(turned: ArmMoment['turned'], target: ArmPicture['target']): void {
    if (!turned) {
      for (const part of [this.rayBefore, this.rayToTarget, this.arc]) part.set(null);
      return;
    }
    const { centre, before, after } = turned;
    const radius = arcShare * Math.min(distanceOf(centre, before), distanceOf(centre, target));
    this.rayBefore.set([...centre, ...before]);
    this.rayToTarget.set([...centre, ...target]);
    this.arc.set(arcBetween(centre, before, after, radius, arcPieces));
  }

  private add<Part extends Lines | Dots>(part: Part): Part {
    this.parts.push(part);
    this.group.add(part.mesh);
    return part;
  }
}
