import { type ReadonlySignal, signal } from '@preact/signals';
import type { Actions } from '../../app/actions.ts';
import { kinematicsLimits } from '../../app/kinematics.ts';
import { notify } from '../../app/notices.ts';
import type { Pose } from '../../app/pose.ts';
import { state } from '../../app/state.ts';
import type { Point2 } from '../../curves/curve.ts';
import { rounded } from './arm_geometry.ts';

/** m: points of a stroke are at least so far apart. */
const apart = 0.01;

export type Stroke = readonly Point2[];

/** The pen that the reader draws a curve on the floor with. Every stroke joins the curve as it ends. */
export class FloorPen {
  /** Whether it is in the reader's hand. */
  readonly on = signal(false);
  /** What it is drawing: m, in the curve's plane. */
  readonly stroke = signal<Stroke>([]);
  /** Where it is, m. */
  readonly place = signal<Point2>([0, 0]);
  readonly isDown = signal(false);
  /** Whether keys have taken it, which will then draw. */
  byKeys = false;
  private readonly actions: Pick<Actions, 'setKinematics'>;
  private readonly pose: ReadonlySignal<Pose | null>;

  /** `pose`: what the arm shows. */
  constructor(actions: Pick<Actions, 'setKinematics'>, pose: ReadonlySignal<Pose | null>) {
    this.actions = actions;
    this.pose = pose;
  }

  /** What was drawn by hand before stays, and goes on; any other curve makes room. */
  take(byKeys: boolean): void {
    this.byKeys = byKeys;
    this.on.value = true;
    if (strokesNow().length === 0) this.clear();
  }

  putAway(): void {
    this.lift();
    this.on.value = false;
  }

  /** Down where it is, or goes there if it is down already. */
  draw(to: Point2): void {
    this.place.value = to;
    this.isDown.value = true;
    this.stroke.value = extended(this.stroke.value, to, strokesNow());
  }

  /** Goes there, and draws if it is down. */
  move(to: Point2): void {
    if (this.isDown.value) this.draw(to);
    else this.place.value = to;
  }

  lift(): void {
    const { value: stroke } = this.stroke;
    this.isDown.value = false;
    this.stroke.value = [];
    const strokes = strokesNow();
    const most = kinematicsLimits.hand;
    if (stroke.length > 0 && (strokes.length === most.strokes || pointsOf(strokes) + stroke.length >= most.points))
      notify('info', 'page.errors.drawnAll', most);
    if (stroke.length < 2 || strokes.length === most.strokes) return;
    this.actions.setKinematics({ mode: 'draw', curve: { kind: 'hand', strokes: [...strokes, stroke] } });
  }

  /** Nothing is to be drawn: the arm stays where it is. */
  clear(): void {
    this.isDown.value = false;
    this.stroke.value = [];
    const effector = this.pose.value?.x.subarray(-3);
    this.actions.setKinematics({ mode: 'aim', ...(effector && { target: rounded(effector) }) });
  }
}

/** The strokes that the next one joins. */
export function strokesNow(): readonly Stroke[] {
  const { mode, curve } = state.value.kinematics;
  return mode === 'draw' && curve.kind === 'hand' ? curve.strokes : [];
}

/** With another point, unless it is too near the last one, too far away, or one too many beside what is there. */
export function extended(stroke: Stroke, [x, y]: Point2, others: readonly Stroke[]): Stroke {
  const point: Point2 = [millimetres(x), millimetres(y)];
  const last = stroke.at(-1);
  if (last && Math.hypot(point[0] - last[0], point[1] - last[1]) < apart) return stroke;
  const { min, max } = kinematicsLimits.coordinate;
  if (point.some((value) => value < min || value > max)) return stroke;
  return pointsOf(others) + stroke.length < kinematicsLimits.hand.points ? [...stroke, point] : stroke;
}

/** How many. */
function pointsOf(strokes: readonly Stroke[]): number {
  return strokes.reduce((sum, { length }) => sum + length, 0);
}

function millimetres(metres: number): number {
  return Math.round(1000 * metres) / 1000 + 0; // no −0, which JSON does not know
}
