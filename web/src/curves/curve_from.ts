import type { CurveChoice } from './curve_choice.ts';
import type { CurveResult } from './curve_problem.ts';
import { formulaCurve } from './formula_curve.ts';
import { handCurve } from './hand_curve.ts';
import { lettersCurve } from './letters_curve.ts';
import { pathCurve } from './path_curve.ts';
import { shape } from './shape.ts';

/** The curve that `choice` describes, or what is wrong with the description. Never throws. */
export function curveFrom(choice: CurveChoice): CurveResult {
  switch (choice.kind) {
    case 'letters':
      return lettersCurve(choice.text);
    case 'formula':
      return formulaCurve(choice);
    case 'hand':
      return handCurve(choice.strokes);
    case 'path':
      return pathCurve(choice.d);
    default:
      return { ok: true, curve: { strokes: [shape(choice.kind)] } };
  }
}
