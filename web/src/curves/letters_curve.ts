import type { Stroke } from './curve.ts';
import { curveLimits } from './curve_choice.ts';
import { type CurveResult, refused } from './curve_problem.ts';
import { fitInBox } from './fit_in_box.ts';
import { baseline, gapBetweenLetters, glyphs } from './glyphs.ts';
import { pathStrokes } from './path_strokes.ts';

/** A line of text in the lab's own stroke font, fitted into the box. */
export function lettersCurve(text: string): CurveResult {
  const characters = [...text];
  if (text.trim() === '') return refused('text', 1, { code: 'empty' });
  const maximum = curveLimits.letters;
  if (characters.length > maximum) return refused('text', maximum + 1, { code: 'too_long', maximum });
  const strokes: Stroke[] = [];
  let left = 0;
  for (const [k, character] of characters.entries()) {
    const glyph = glyphs[character.normalize('NFKC')]; // full-width forms, as Chinese input methods give them
    if (!glyph) return refused('text', k + 1, { code: 'no_such_letter', character });
    const [width, d] = glyph;
    strokes.push(...glyphStrokes(d, left));
    left += width + gapBetweenLetters;
  }
  return { ok: true, curve: { strokes: fitInBox(strokes, baseline) as Stroke[] } };
}

function glyphStrokes(d: string, left: number): Stroke[] {
  if (d === '') return [];
  return (pathStrokes(d) as Stroke[]).map((stroke) => ({
    ...stroke,
    at(t) {
      const [x, y] = stroke.at(t);
      return [x + left, y];
    },
  }));
}
