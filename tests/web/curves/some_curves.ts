import { expect } from 'vitest';
import type { Curve } from '../../../web/src/curves/curve.ts';
import type { CurveChoice } from '../../../web/src/curves/curve_choice.ts';
import { curveFrom } from '../../../web/src/curves/curve_from.ts';

export function curveOf(choice: CurveChoice): Curve {
  const result = curveFrom(choice);
  if (!result.ok) throw new Error(JSON.stringify(result.problem));
  return result.curve;
}

export function problemOf(choice: CurveChoice) {
  const result = curveFrom(choice);
  expect(result.ok).toBe(false);
  return result.ok ? null : result.problem;
}

export const someChoices: CurveChoice[] = [
  { kind: 'circle' },
  { kind: 'square' },
  { kind: 'heart' },
  { kind: 'triangle' },
  { kind: 'star' },
  { kind: 'letters', text: 'Hi, you?' },
  { kind: 'formula', x: 'sin(2t)', y: 't²/9', from: '0', to: '2 pi' },
  { kind: 'formula', x: 'abs(t)', y: 'exp(t)/9', from: '-1', to: '2' },
  {
    kind: 'hand',
    strokes: [
      [
        [0, 0],
        [0.3, 0.1],
        [0.4, 0.5],
      ],
      [
        [-1, 0],
        [-1, 0.2],
      ],
    ],
  },
  { kind: 'path', d: 'M0 0h10v10z M20 0q5 5 10 0t10 0 a3 4 30 1 0 5 5' },
];
