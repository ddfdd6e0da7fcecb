import { Group } from 'three';
import type { Drawing } from '../../app/kinematics_drawing.ts';
import { distanceOf } from './arm_geometry.ts';
import type { ArmPalette } from './arm_palette.ts';
import { mixHex } from './colour.ts';
import { Dots } from './dots.ts';
import type { Ink } from './ink.ts';
import { Lines } from './lines.ts';

/** A curve on the floor, and what the arm has made of it. Nobody changes the arrays. */
export interface ArmCurve {
  /** #S×3, m: targets at which the pen is down. */
  targets: Float64Array;
  /** #S: the stroke that each belongs to. */
  stroke: Int32Array;
  /** #S×3, m: where the end effector came to at each. */
  effector: Float64Array;
  /** #T: how many of these have been gone to at each target, those in the air included. */
  gone: Int32Array;
}

/** What of a drawing is on the floor. */
export function armCurveOf({ targets, strokes, followed }: Omit<Drawing, 'epsilon'>): ArmCurve {
  const joints = followed.x.length / targets.length;
  const rows = Array.from(strokes, (_, i) => i).filter((i) => strokes[i] >= 0);
  let gone = 0;
  return {
    targets: Float64Array.from(rows.flatMap((i) => [...targets.subarray(3 * i, 3 * i + 3)])),
    stroke: Int32Array.from(rows, (i) => strokes[i]),
    effector: Float64Array.from(
      rows.flatMap((i) => [...followed.x.subarray(3 * joints * (i + 1) - 3, 3 * joints * (i + 1))]),
    ),
    gone: strokes.map((stroke) => (stroke >= 0 ? ++gone : gone)),
  };
}

/** CSS pixels. */
const style = { line: 1.25, trail: 5 };
/** Radius of a target's dot: a share of how far it is to the next, as long as that is enough to tell them apart. */
const dot = { share: 0.3, least: 0.9, most: 3 };
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
  /** m: the mean one between neighbours. */
  private gap = 0;

  constructor(ink: Ink, capacity: number) {
    this.wanted = new Lines(ink, 'net', capacity);
    this.trail = new Lines(ink, 'net', capacity);
    this.targets = new Dots(ink, 'net', capacity, 'disc');
    this.reached = new Dots(ink, 'net', capacity, 'disc');
    this.group.add(this.wanted.mesh, this.trail.mesh, this.targets.mesh, this.reached.mesh);
  }

  setStyle({ target, effector, background }: ArmPalette, pixelsPerMetre: number): void {
    const faint = mixHex(background, target, ahead);
    const radius = Math.min(dot.most, dot.share * this.gap * pixelsPerMetre);
    const dots = { radius: radius < dot.least ? 0 : radius, halo: 0, haloColour: background };
    this.wanted.setStyle({ width: style.line, colour: faint });
    this.targets.setStyle({ ...dots, colour: faint });
    this.reached.setStyle({ ...dots, colour: target });
    this.trail.setStyle({ width: style.trail, colour: effector });
  }

  /** `place`: the target that the arm is at. */
  show(curve: ArmCurve | null, place: number): void {
    if (curve !== this.shown) this.take(curve);
    this.shown = curve;
    if (!curve) return;
    const count = curve.stroke.length;
    const gone = curve.gone[Math.min(place, curve.gone.length - 1)];
    const segments = gone > 0 ? this.segmentsAt[gone - 1] : 0;
    this.reached.marks.show(0, gone);
    this.targets.marks.show(gone, count - gone);
    this.trail.segments.show(0, segments);
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
    this.gap = curve ? meanLength(curve.targets, pairs) : 0;
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

/** m: of segments between points (#×3, m). */
function meanLength(points: Float64Array, pairs: readonly number[]): number {
  let sum = 0;
  for (let at = 0; at < pairs.length; at += 2) {
    const [a, b] = [3 * pairs[at], 3 * pairs[at + 1]];
    sum += distanceOf(points.subarray(a, a + 3), points.subarray(b, b + 3));
  }
  return (2 * sum) / pairs.length;
}
