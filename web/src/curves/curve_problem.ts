import type { Curve } from './curve.ts';

export type CurveField = 'text' | 'x' | 'y' | 'from' | 'to' | 'd' | 'strokes';

/** What is wrong, with the values that a sentence about it needs. */
export type CurveReason =
  | { code: 'empty' }
  | { code: 'too_long'; maximum: number }
  /** The pen would not move. */
  | { code: 'no_length' }
  // letters
  | { code: 'no_such_letter'; character: string }
  // formulas
  | { code: 'unexpected'; found: string }
  | { code: 'ends_early' }
  | { code: 'not_closed' }
  | { code: 'not_opened' }
  | { code: 'nested_too_deep'; maximum: number }
  | { code: 'unknown_name'; name: string }
  | { code: 'function_without_parentheses'; name: string }
  | { code: 'wrong_number_of_arguments'; name: string; count: number }
  | { code: 'contains_t' }
  | { code: 'not_finite'; t: number }
  | { code: 'bound_not_finite' }
  | { code: 'too_far'; t: number; value: number; maximum: number }
  | { code: 'empty_range'; from: number; to: number }
  // strokes by hand; the column is the stroke's number
  | { code: 'point_too_far'; maximum: number }
  // SVG paths
  | { code: 'not_path_data'; found: string }
  | { code: 'path_ends_early' }
  | { code: 'no_move_first'; found: string }
  | { code: 'too_large'; found: string; maximum: number }
  | { code: 'too_many_corners'; count: number; maximum: number }
  | { code: 'no_path_in_markup' };

export type CurveProblem = CurveReason & {
  field: CurveField;
  /** Which character of the field is at fault, from 1; one behind its last where something is missing. */
  column: number;
};

export type CurveResult = { ok: true; curve: Curve } | { ok: false; problem: CurveProblem };

/** What a character at `index` of `text` is called: characters beyond the Basic Multilingual Plane count as one. */
export function columnAt(text: string, index: number): number {
  return [...text.slice(0, index)].length + 1;
}

export function refused(field: CurveField, column: number, reason: CurveReason): { ok: false; problem: CurveProblem } {
  return { ok: false, problem: { field, column, ...reason } };
}
