import { DirectionalLight, HemisphereLight, type PerspectiveCamera, Scene } from 'three';
import { kinematicsLimits } from '../../app/kinematics.ts';
import { ArmBody, radiusOf } from './arm_body.ts';
import { ArmCurveMarks } from './arm_curve.ts';
import { ArmFloor } from './arm_floor.ts';
import { ArmMarks } from './arm_marks.ts';
import type { ArmPalette } from './arm_palette.ts';
import { type ArmPicture, reachIn } from './arm_picture.ts';
import type { Ink } from './ink.ts';
import { Lines } from './lines.ts';

/** Light from the sky and from the floor, and a soft one that goes with the eye. */
const light = { sky: 0xffffff, floor: 0xb9c0ca, around: 1.9, lamp: 1.5 };

/** Everything that is allocated for a picture of an arm. */
export class ArmContent {
  readonly scene = new Scene();
  private readonly lamp = new DirectionalLight(0xffffff, light.lamp);
  private readonly floor = new ArmFloor();
  private readonly body = new ArmBody();
  private readonly marks: ArmMarks;
  private readonly curve: ArmCurveMarks;
  private readonly stroke: Lines;
  private palette: ArmPalette | null = null;

  constructor(ink: Ink) {
    this.marks = new ArmMarks(ink);
    this.curve = new ArmCurveMarks(ink, kinematicsLimits.points.max);
    this.stroke = new Lines(ink, 'arrow', kinematicsLimits.hand.points);
    this.scene.add(new HemisphereLight(light.sky, light.floor, light.around), this.lamp);
    this.scene.add(this.floor.mesh, this.body.group, this.curve.group, this.marks.group, this.stroke.mesh);
  }

  /** What changed since the last picture. */
  refresh(picture: ArmPicture, before: ArmPicture | null): void {
    const { x, root, palette, moment, curve, place, stroke } = picture;
    const reach = reachIn(picture);
    if (palette !== this.palette) this.setStyle(palette);
    this.floor.place(root[0], root[2], reach);
    this.body.show(x, root, reach, moment?.turned?.joint ?? null, palette);
    this.curve.show(curve, place);
    this.marks.show(picture);
    if (stroke !== before?.stroke) this.stroke.set(stroke);
  }

  /** Just before drawing. */
  lightFrom({ position }: PerspectiveCamera): void {
    this.lamp.position.copy(position);
    this.lamp.position.y += 0.5 * position.length();
  }

  /** m: of what ink counts as lying behind. */
  depthOf(picture: ArmPicture): number {
    return radiusOf(reachIn(picture), picture.lengths.length);
  }

  dispose(): void {
    for (const part of [this.floor, this.body, this.marks, this.curve, this.stroke, this.lamp]) part.dispose();
  }

  private setStyle(palette: ArmPalette): void {
    this.palette = palette;
    this.floor.setColours(palette);
    this.marks.setStyle(palette);
    this.curve.setStyle(palette);
    this.stroke.setStyle({ width: 3, colour: palette.target });
  }
}
