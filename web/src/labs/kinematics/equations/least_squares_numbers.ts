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
    share: shareOf(missing, rays, turns),
  };
}

/** Exponents of two: λ² beyond is too small, or too large, to be told from none. */
const exponents = Array.from({ length: 121 }, (_, at) => at - 60);

/** The damping is not in the trace, but it is a power of two times ‖e‖², which begins with 1, is halved and raised by fours: the one that makes these turns. */
function shareOf(missing: Vector, rays: readonly Vector[], turns: readonly Vector[]): number | null {
  // (J Jᵀ + λ²I) y = e with J Jᵀ = Σ ‖s‖² I − s sᵀ, Δ_i = s_i × y
  const JJT = worldAxes.map((axis) =>
    rays.map((s) => subtract(scale(dot(s, s), axis), scale(dot(axis, s), s))).reduce(add),
  );
  const misfits = exponents.map((exponent) => {
    const damping = 2 ** exponent * dot(missing, missing);
    const y = solve3(
      JJT.map((line, at) => add(line, scale(damping, worldAxes[at]))),
      missing,
    );
    return y ? norm(turns.map((turn, i) => norm(subtract(turn, cross(rays[i], y))))) : Number.POSITIVE_INFINITY;
  });
  const best = misfits.indexOf(Math.min(...misfits));
  const others = Math.min(misfits[best - 1] ?? 0, misfits[best + 1] ?? 0);
  const isPlain = misfits[best] <= singlePrecision * norm(turns.map(norm)) && 4 * misfits[best] < others;
  return isPlain ? 2 ** exponents[best] : null;
}

/** Of a turn: what single precision may lose of it. */
const singlePrecision = 1e-3;
