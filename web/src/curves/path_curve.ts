import { curveLimits } from './curve_choice.ts';
import { type CurveResult, columnAt, refused } from './curve_problem.ts';
import { fitInBox } from './fit_in_box.ts';
import { pathDataIn } from './path_data_in.ts';
import { pathStrokes } from './path_strokes.ts';
import { fewestPoints } from './sample_curve.ts';

/** An SVG path, or all paths of pasted markup, fitted into the box. */
export function pathCurve(text: string): CurveResult {
  if (text.trim() === '') return refused('d', 1, { code: 'empty' });
  const maximum = curveLimits.path;
  if (text.length > maximum) return refused('d', columnAt(text, maximum), { code: 'too_long', maximum });
  const found = pathDataIn(text);
  if (found.length === 0) return refused('d', 1, { code: 'no_path_in_markup' });
  const strokes = [];
  for (const { d, index } of found) {
    const read = pathStrokes(d);
    if ('reason' in read) return refused('d', columnAt(text, index + read.index), read.reason);
    strokes.push(...read);
  }
  const count = fewestPoints({ strokes });
  const most = curveLimits.points.max;
  if (count > most) return refused('d', 1, { code: 'too_many_corners', count, maximum: most });
  const fitted = fitInBox(strokes);
  return fitted ? { ok: true, curve: { strokes: fitted } } : refused('d', 1, { code: 'no_length' });
}
