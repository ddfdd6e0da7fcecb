import { Group } from 'three';
import { kinematicsLimits } from '../../app/kinematics.ts';
import { arcBetween, distanceOf } from './arm_geometry.ts';
import type { ArmMoment } from './arm_moment.ts';
import type { ArmPalette } from './arm_palette.ts';
import type { ArmPicture } from './arm_picture.ts';
import { Dots } from './dots.ts';
import type { Ink } from './ink.ts';
import { Lines } from './lines.ts';

const mostJoints = kinematicsLimits.links.max + 1;
const arcPieces = 24;
/** Of them, those that the arrow head takes. */
const headPieces = 4;
/** The arc of an angle: a share of the shorter of its two rays. */
const arcShare = 0.55;

/** What explains one event of a search: the pose that it began with, and the joint that has turned or the root that was left. */
export class ArmMomentMarks {
  readonly group = new Group();
  private readonly ghostLinks: Lines;
  private readonly ghostJoints: Dots;
  private readonly toEffector: Lines;
  private readonly toTarget: Lines;
  private readonly arc: Lines;
  private readonly arcHead: Lines;
  private readonly leash: Lines;
  private readonly leftRoot: Dots;

  constructor(ink: Ink) {
    this.ghostLinks = new Lines(ink, 'ghost', mostJoints - 1);
    this.ghostJoints = new Dots(ink, 'ghost', mostJoints, 'disc');
    this.toEffector = new Lines(ink, 'arrow', 1);
    this.toTarget = new Lines(ink, 'arrow', 1);
    this.arc = new Lines(ink, 'arrow', arcPieces);
    this.arcHead = new Lines(ink, 'arrow', 1);
    this.leash = new Lines(ink, 'arrow', 1);
    this.leftRoot = new Dots(ink, 'pin', 1, 'ring');
    for (const { mesh } of this.parts()) this.group.add(mesh);
  }

  /** Lengths in CSS pixels. */
  setStyle({ background, ghost, target, effector, turned, joint }: ArmPalette): void {
    const halo = { halo: 1.5, haloColour: background };
    this.ghostLinks.setStyle({ width: 5, colour: ghost });
    this.ghostJoints.setStyle({ radius: 5, halo: 0, haloColour: background, colour: ghost });
    this.toEffector.setStyle({ width: 1.75, dash: 4, colour: effector, ...halo });
    this.toTarget.setStyle({ width: 1.75, dash: 4, colour: target, ...halo });
    this.arc.setStyle({ width: 3, colour: turned });
    this.arcHead.setStyle({ width: 3, head: 12, colour: turned });
    this.leash.setStyle({ width: 1.5, dash: 4, colour: joint });
    this.leftRoot.setStyle({ radius: 9, ...halo, colour: joint });
  }

  show({ x, root, target, moment }: Pick<ArmPicture, 'x' | 'root' | 'target' | 'moment'>): void {
    this.ghostLinks.set(moment?.ghost ?? null);
    this.ghostJoints.set(moment?.ghost ?? null);
    this.leftRoot.set(moment?.detached ? root : null);
    this.leash.set(moment?.detached ? [...root, ...x.subarray(0, 3)] : null);
    if (moment?.turned) this.showTurn(moment.turned, target);
    else for (const part of [this.toEffector, this.toTarget, this.arc, this.arcHead]) part.set(null);
  }

  dispose(): void {
    for (const part of this.parts()) part.dispose();
  }

  private showTurn({ centre, before, after }: NonNullable<ArmMoment['turned']>, target: ArmPicture['target']): void {
    const radius = arcShare * Math.min(distanceOf(centre, before), distanceOf(centre, target));
    const arc = arcBetween(centre, before, after, radius, arcPieces);
    const neck = 3 * (arcPieces - headPieces);
    this.toEffector.set([...centre, ...before]);
    this.toTarget.set([...centre, ...target]);
    this.arc.set(arc.subarray(0, neck + 3));
    this.arcHead.set([...arc.subarray(neck, neck + 3), ...arc.subarray(-3)]);
  }

  private parts(): (Lines | Dots)[] {
    const { ghostLinks, ghostJoints, toEffector, toTarget, arc, arcHead, leash, leftRoot } = this;
    return [ghostLinks, ghostJoints, toEffector, toTarget, arc, arcHead, leash, leftRoot];
  }
}
