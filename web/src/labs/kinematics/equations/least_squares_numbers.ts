import type { Search } from '../../../app/kinematics_session.ts';
import { conjugate, multiply, type Quaternion, quaternionAt, rotate, rotationVector } from '../../../lib/quaternion.ts';
import { add, cross, dot, norm, row, scale, subtract, type Vector } from '../../../lib/vector.ts';
import { type Moment, missingAt } from '../trace/moment.ts';
import { solve3 } from './solve3.ts';

/** One iteration of damped least squares. */
export interface LeastSquaresNumbers {
  /** e = x* − x_n before, m. */
  missing: Vector;
  /** J Δ, m: what the turns would move the end effector by if they were small. */
  promised: Vector;
  /** m: what they have moved it by. */
  moved: Vector;
  /** Of each joint that turns a link: axis times angle in the world, rad. */
  turns: Vector[];
  /** Of each such joint: its three columns of J, m. */
  columns: readonly (readonly [Vector, Vector, Vector])[];
  /** λ²/‖e‖², a power of two; null where the turns do not say it: a limit held them, or it is lost in rounding. */
  share: number | null;
}

const worldAxes: readonly [Vector, Vector, Vector] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

export function leastSquaresNumbers(search: Search, { before, after }: Moment): LeastSquaresNumbers {
  const links = before.x.length / 3 - 1;
  const effector = row(before.x, links);
  const missing = missingAt(search, before);
  const rays = Array.from({ length: links }, (_, i) => subtract(effector, row(before.x, i)));
  const turns: Vector[] = [];
  let R: Quaternion = [0, 0, 0, 1];
  for (let i = 0; i < links; i++) {
    const own = quaternionAt(before.q, i);
    R = multiply(R, own);
    turns.push(rotate(R, rotationVector(multiply(conjugate(own), quaternionAt(after.q, i)))));
  }
  const promised = turns.map((turn, i) => cross(turn, rays[i])).reduce(add);
  return {
    missing,
    promised,
    moved: subtract(row(after.x, links), effector),
    turns,
    columns: rays.map((ray) => worldAxes.map((axis) => cross(axis, ray)) as [Vector, Vector, Vector]),
    share: shareOf(missing, rays, turns, promised),
  };
}

/** Beside a power of two, relatively: twos apart leave no doubt. */
const doubt = 0.05;

/**
 * The damping is not in the trace, but the turns tell it: Δ = Jᵀy with (J Jᵀ + λ²I) y = e, so that y is the solution of J Jᵀ y = J Δ, and
 * λ² y = e − J Δ. The solver begins with λ² = ‖e‖², halves and multiplies by four.
 */
function shareOf(missing: Vector, rays: readonly Vector[], turns: readonly Vector[], promised: Vector): number | null {
  // J Jᵀ = Σ ‖s‖² I − s sᵀ
  const JJT = worldAxes.map((axis) =>
    rays.map((s) => subtract(scale(dot(s, s), axis), scale(dot(axis, s), s))).reduce(add),
  );
  const y = solve3(JJT, promised);
  if (!y || turns.some((turn, i) => !agree(turn, cross(rays[i], y)))) return null;
  const share = dot(subtract(missing, promised), y) / dot(y, y) / dot(missing, missing);
  const power = 2 ** Math.round(Math.log2(share));
  return Math.abs(share / power - 1) < doubt ? power : null;
}

/** To what single precision leaves of a turn. */
function agree(a: Vector, b: Vector): boolean {
  return norm(subtract(a, b)) <= 1e-3 * norm(a) + 1e-9;
}
