import type { Point3 } from '../../app/kinematics.ts';
import type { Point2 } from '../../curves/curve.ts';
import { fillTemplate } from '../../lib/fill_template.ts';
import { formatFixed, formatQuantity } from '../../lib/format.ts';
import type { IkAnswer } from '../../solver/inverse_kinematics.ts';
import type { en } from './arm_en.ts';

type Words = Pick<typeof en, 'target' | 'report' | 'outcome' | 'pen' | 'penDown' | 'penUp'>;

/** What became of a search. */
export type Came = Pick<IkAnswer, 'outcome' | 'error'>;

/** Where the target is, and what became of it. */
export function targetText(words: Words, [x, y, z]: Point3, came: Came | null): string {
  const place = fillTemplate(words.target, { x: formatFixed(x, 3), y: formatFixed(y, 3), z: formatFixed(z, 3) });
  if (!came) return place;
  const outcome = fillTemplate(words.outcome[came.outcome], { error: formatQuantity(1e3 * came.error, 'mm') });
  return fillTemplate(words.report, { place, outcome });
}

export function penText(words: Words, [x, y]: Point2, isDown: boolean): string {
  const state = isDown ? words.penDown : words.penUp;
  return fillTemplate(words.pen, { x: formatFixed(x, 2), y: formatFixed(y, 2), state });
}
