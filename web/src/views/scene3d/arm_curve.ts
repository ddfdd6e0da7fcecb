import { Group } from 'three';
import type { ArmPalette } from './arm_palette.ts';
import { mixHex } from './colour.ts';
import { Dots } from './dots.ts';
import type { Ink } from './ink.ts';
import { Lines } from './lines.ts';

/** A curve that is drawn from target to target; nobody changes the arrays. */
export interface ArmCurve {
  /** #T×3, m. */
  targets: Float64Array;
  /** #T: the stroke that each belongs to. Between two strokes the pen is up. */
  stroke: Int32Array;
  /** #T×3, m: where the end effector came to at each; null while that is unknown. */
  effector: Float64Array | null;
}

/** CSS pixels. */
const style = { line: 1.25, dot: 2.25, trail: 4 };
/** How much of its colour what is not drawn yet has. */
const ahead = 0.45;

/** What is to be drawn, dot by dot, and the line that the arm has really left. */
export class ArmCurveMarks {
  readonly group = new Group();
  private readonly wanted: Lines;
  private readonly targets: Dots;
  private readonly reached: Dots;
  private readonly trail: Lines;
  private shown: ArmCurve | null = null;
  /** #T: how many segments lie before and at each target. */
  private segmentsAt: Int32Array = new Int32Array();

  constructor(ink: Ink, capacity: number) {
    this.wanted = new Lines(ink, 'net', capacity);
    this.trail = new Lines(ink, 'net', capacity);
    this.targets = new Dots(ink, 'net', capacity, 'disc');
    this.reached = new Dots(ink, 'net', capacity, 'disc');
    this.group.add(this.wanted.mesh, this.trail.mesh, this.targets.mesh, this.reached.mesh);
  }

  setStyle({ target, effector, background }: ArmPalette): void {
    const faint = mixHex(background, target, ahead);
    const dot = { radius: style.dot, halo: 0, haloColour: background };
    this.wanted.setStyle({ width: style.line, colour: faint });
    this.targets.setStyle({ ...dot, colour: faint });
    this.reached.setStyle({ ...dot, colour: target });
    this.trail.setStyle({ width: style.trail, colour: effector });
  }

  /** `place`: how many targets have been gone to. */
  show(curve: ArmCurve | null, place: number): void {
    if (curve !== this.shown) this.take(curve);
    this.shown = curve;
    if (!curve) return;
    const count = curve.targets.length / 3;
    const segments = place > 0 ? this.segmentsAt[place - 1] : 0;
    this.reached.marks.show(0, place);
    this.targets.marks.show(place, count - place);
    this.trail.segments.show(0, segments);
    this.trail.mesh.visible = curve.effector !== null && segments > 0;
  }

  dispose(): void {
    for (const part of [this.wanted, this.targets, this.reached, this.trail]) part.dispose();
  }

  private take(curve: ArmCurve | null): void {
    const pairs = curve ? penPairs(curve.stroke) : [];
    this.wanted.set(curve?.targets ?? null, pairs);
    this.targets.set(curve?.targets ?? null);
    this.reached.set(curve?.targets ?? null);
    this.trail.set(curve?.effector ?? null, pairs);
    this.segmentsAt = curve ? segmentsAt(curve.stroke) : new Int32Array();
  }
}

/** #segments×2: rows of neighbours in one stroke. */
export function penPairs(stroke: ArrayLike<number>): number[] {
  const pairs: number[] = [];
  for (let i = 1; i < stroke.length; i++) if (stroke[i] === stroke[i - 1]) pairs.push(i - 1, i);
  return pairs;
}

/** #T: how many of these end at or before each. */
export function segmentsAt(stroke: ArrayLike<number>): Int32Array {
  let segments = 0;
  return Int32Array.from({ length: stroke.length }, (_, i) => {
    if (i > 0 && stroke[i] === stroke[i - 1]) segments++;
    return segments;
  });
}
