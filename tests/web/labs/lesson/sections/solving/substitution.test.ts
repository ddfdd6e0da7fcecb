import { describe, expect, it } from 'vitest';
import { rowFormula, substitutionAt } from '../../../../../../web/src/labs/lesson/sections/solving/substitution.ts';

// L x = b and Lᵀ p = x by hand: x = (1, 2), p = (−1.5, 2).
const L = [
  [2, 0],
  [2, 1],
];
const b = [2, 4];

describe('substitutionAt', () => {
  it.each([
    { step: 0, x: [null, null], p: [null, null], solved: null },
    { step: 1, x: [1, null], p: [null, null], solved: { pass: 'forwards', row: 0 } },
    { step: 2, x: [1, 2], p: [null, null], solved: { pass: 'forwards', row: 1 } },
    { step: 3, x: [1, 2], p: [null, 2], solved: { pass: 'backwards', row: 1 } },
    { step: 4, x: [1, 2], p: [-1.5, 2], solved: { pass: 'backwards', row: 0 } },
  ])('knows after $step rows what is solved', ({ step, ...moment }) => {
    expect(substitutionAt(L, b, step)).toEqual(moment);
  });
});

describe('rowFormula', () => {
  it('uses the rows above on the way down and those below on the way up', () => {
    expect(rowFormula(3, { pass: 'forwards', row: 1 })).toBe(
      String.raw`x_{1} = \frac{\symb_{1} - \symL_{10}\,x_{0}}{\symL_{11}}`,
    );
    expect(rowFormula(3, { pass: 'backwards', row: 1 })).toBe(
      String.raw`\symp_{1} = \frac{x_{1} - \symL_{21}\,\symp_{2}}{\symL_{11}}`,
    );
  });
});
