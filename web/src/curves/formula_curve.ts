import type { Point2 } from './curve.ts';
import type { CurveChoice } from './curve_choice.ts';
import { type CurveResult, refused } from './curve_problem.ts';
import { type Formula, parseFormula } from './formula.ts';

type FormulaChoice = Extract<CurveChoice, { kind: 'formula' }>;

/** How many equal steps of t are looked at before anything is drawn. */
const steps = 2000;
/** m. Several times what any arm of the lab reaches. */
const farthest = 100;

/** The curve of two typed formulas, in m as they stand: it is not fitted into a box. */
export function formulaCurve(choice: FormulaChoice): CurveResult {
  const read: Partial<Record<'x' | 'y' | 'from' | 'to', Formula>> = {};
  for (const field of ['x', 'y', 'from', 'to'] as const) {
    const formula = parseFormula(choice[field]);
    if ('reason' in formula) return refused(field, formula.column, formula.reason);
    read[field] = formula;
  }
  const { x, y, from: first, to: last } = read as Required<typeof read>;
  for (const [field, bound] of [['from', first] as const, ['to', last] as const]) {
    if (bound.columnOfT !== null) return refused(field, bound.columnOfT, { code: 'contains_t' });
    if (!Number.isFinite(bound.at(0))) return refused(field, 1, { code: 'bound_not_finite' });
  }
  const from = first.at(0);
  const to = last.at(0);
  // The steps between must differ too.
  if (!(to - from > 1e-9 * Math.max(Math.abs(from), Math.abs(to))))
    return refused('to', 1, { code: 'empty_range', from, to });
  if (!Number.isFinite(to - from)) return refused('to', 1, { code: 'bound_not_finite' });

  const grid = (k: number) => (k === steps ? to : from + ((to - from) * k) / steps);
  let moves = false;
  for (let k = 0; k <= steps; k++) {
    const t = grid(k);
    for (const [field, formula] of [['x', x] as const, ['y', y] as const]) {
      const value = formula.at(t);
      if (!Number.isFinite(value)) return refused(field, 1, { code: 'not_finite', t });
      if (Math.abs(value) > farthest) return refused(field, 1, { code: 'too_far', t, value, maximum: farthest });
      moves ||= Math.abs(value - formula.at(from)) > 1e-9;
    }
  }
  if (!moves) return refused('x', 1, { code: 'no_length' });

  const at = (t: number): Point2 => [x.at(t), y.at(t)];
  const isThere = ([x, y]: Point2) => Math.abs(x) <= farthest && Math.abs(y) <= farthest; // not so for NaN
  return {
    ok: true,
    curve: {
      strokes: [
        {
          from,
          to,
          at(t) {
            const point = at(t);
            // A hole narrower than the steps: the pen stays where it was seen last.
            return isThere(point) ? point : at(grid(Math.floor(((t - from) / (to - from)) * steps)));
          },
          corners: [],
          closed: isClosed(at(from), at(to)),
        },
      ],
    },
  };
}

/** Whether the ends meet, but for the rounding of sines of multiples of π. */
function isClosed([ax, ay]: Point2, [bx, by]: Point2): boolean {
  return Math.hypot(bx - ax, by - ay) < 1e-9;
}
