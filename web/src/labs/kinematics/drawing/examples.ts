import type { CurveChoice } from '../../../curves/curve_choice.ts';

type ChoiceOf<Kind extends CurveChoice['kind']> = Extract<CurveChoice, { kind: Kind }>;
export type FormulaChoice = ChoiceOf<'formula'>;
export type LettersChoice = ChoiceOf<'letters'>;
export type PathChoice = ChoiceOf<'path'>;

function formula(x: string, y: string, to: string): FormulaChoice {
  return { kind: 'formula', x, y, from: '0', to };
}

/** Curves with a name, in m. */
export const formulas = {
  lissajous: formula('0.8 sin(3t)', '0.5 sin(2t)', '2 pi'),
  rose: formula('0.7 cos(2t) cos(t)', '0.7 cos(2t) sin(t)', '2 pi'),
  spiral: formula('0.03 t cos(t)', '0.03 t sin(t)', '8 pi'),
  cycloid: formula('0.13 (t - sin(t)) - 0.82', '0.13 (1 - cos(t))', '4 pi'),
  butterfly: formula(
    '0.2 sin(t) (exp(cos(t)) - 2 cos(4t) - sin(t/12)^5)',
    '0.2 cos(t) (exp(cos(t)) - 2 cos(4t) - sin(t/12)^5)',
    '12 pi',
  ),
} satisfies Record<string, FormulaChoice>;

export type FormulaName = keyof typeof formulas;

/** What is drawn first when a kind of curve is chosen. */
export const first = {
  letters: { kind: 'letters', text: 'Hello' } satisfies LettersChoice,
  formula: formulas.lissajous,
  // A rabbit's head: ears, cheeks and chin in one line.
  path: {
    kind: 'path',
    d: 'M30 62C14 30 18 2 28 2S44 26 46 50Q50 49 54 50C56 26 62 2 72 2S86 30 70 62C90 84 76 100 50 100S10 84 30 62Z',
  } satisfies PathChoice,
};

/** For the button of what is drawn by hand. */
export const wave: CurveChoice = {
  kind: 'hand',
  strokes: [
    [
      [0, 0.1],
      [0.15, 0.45],
      [0.35, 0.5],
      [0.4, 0.1],
      [0.55, -0.05],
      [0.8, 0.3],
      [0.95, 0.2],
    ],
  ],
};
