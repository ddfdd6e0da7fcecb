import { Scene } from 'three';
import { kinematicsLimits, reachOf } from '../../app/kinematics.ts';
import { ArmBody, radiusOf } from './arm_body.ts';
import { ArmCurveMarks } from './arm_curve.ts';
import { ArmFloor } from './arm_floor.ts';
import { ArmMomentMarks } from './arm_moment_marks.ts';
import type { ArmPalette } from './arm_palette.ts';
import type { ArmPicture } from './arm_picture.ts';
import { ArmReach } from './arm_reach.ts';
import { ArmTargetMarks } from './arm_target.ts';
import { Dots } from './dots.ts';
import type { Ink } from './ink.ts';
import { Lines } from './lines.ts';

/** Every stroke has at least two points of the curve, and one more where it closes. */
const mostTargets = 1.5 * kinematicsLimits.points.max;

/** Everything that is allocated for a picture of an arm. */
export class ArmContent {
  readonly scene = new Scene();
  private readonly floor: ArmFloor;
  private readonly reach: ArmReach;
  private readonly body = new ArmBody();
  private readonly moment: ArmMomentMarks;
  private readonly target: ArmTargetMarks;
  private readonly curve: ArmCurveMarks;
  private readonly stroke: Lines;
  private readonly pointed: Dots;
  private drawn: ArmPicture | null = null;

  constructor(ink: Ink) {
    this.floor = new ArmFloor(ink);
    this.reach = new ArmReach(ink);
    this.moment = new ArmMomentMarks(ink);
    this.target = new ArmTargetMarks(ink);
    this.curve = new ArmCurveMarks(ink, mostTargets);
    this.stroke = new Lines(ink, 'arrow', kinematicsLimits.hand.points);
    this.pointed = new Dots(ink, 'highlight', 1, 'ring');
    for (const { group } of [this.floor, this.reach, this.body, this.curve, this.target, this.moment])
      this.scene.add(group);
    this.scene.add(this.stroke.mesh, this.pointed.mesh);
  }

  /** Takes over what has changed since the picture before. */
  refresh(picture: ArmPicture, pixelsPerMetre: number): void {
    const { x, root, links, palette, moment, curve, place, pointedJoint } = picture;
    const before = this.drawn;
    const isNew = (...parts: (keyof ArmPicture)[]) => !before || parts.some((part) => picture[part] !== before[part]);
    if (isNew('palette')) this.setStyle(palette);
    if (isNew('links', 'root')) {
      this.floor.place(root[0], root[2], reachOf(picture));
      this.reach.show(picture);
    }
    if (isNew('x', 'links', 'root', 'moment', 'palette'))
      this.body.show(x, root, radiusOf(reachOf(picture), links.length), moment?.turned?.joint ?? null, palette);
    if (isNew('target')) this.target.show(picture.target);
    if (isNew('moment', 'x', 'target', 'root')) this.moment.show(picture);
    if (isNew('stroke')) this.stroke.set(picture.stroke);
    if (isNew('pointedJoint', 'x')) this.pointed.set(jointAt(x, pointedJoint));
    this.curve.show(curve, place);
    this.curve.setStyle(palette, pixelsPerMetre);
    this.drawn = picture;
  }

  dispose(): void {
    const { floor, reach, body, moment, target, curve, stroke, pointed } = this;
    for (const part of [floor, reach, body, moment, target, curve, stroke, pointed]) part.dispose();
  }

  private setStyle(palette: ArmPalette): void {
    for (const part of [this.floor, this.reach, this.moment, this.target]) part.setStyle(palette);
    this.stroke.setStyle({ width: 3, colour: palette.target });
    this.pointed.setStyle({ radius: 14, halo: 3, haloColour: palette.glow, colour: palette.pointed });
  }
}

/** #3, m; null where the arm has no such joint. */
function jointAt(x: Float64Array, joint: number | null): Float64Array | null {
  return joint !== null && 3 * joint < x.length ? x.subarray(3 * joint, 3 * joint + 3) : null;
}
