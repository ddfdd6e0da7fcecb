import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Formula, parseFormula } from '../../../web/src/curves/formula.ts';

const t = 1.7;

function value(text: string): number {
  const formula = parseFormula(text);
  if ('reason' in formula) throw new Error(`${text}: ${JSON.stringify(formula)}`);
  return formula.at(t);
}

describe('parseFormula', () => {
  it.each([
    // A sign before a power is not part of it, and powers group from the right.
    ['-t^2', -(t ** 2)],
    ['(-t)^2', t ** 2],
    ['2^-t', 2 ** -t],
    ['2^3^2', 512],
    ['-2^-2^2', -(2 ** -4)],
    ['1 - 2 - 3', -4],
    ['8 / 4 / 2', 1],
    ['2 + 3*4', 14],
    ['--t', t],
    ['+t', t],
    // Products without a sign.
    ['2 sin(t)', 2 * Math.sin(t)],
    ['2pi t', 2 * Math.PI * t],
    ['2πt', 2 * Math.PI * t],
    ['t(t+1)', t * (t + 1)],
    ['(t)(t)', t * t],
    ['sin(t)cos(t)', Math.sin(t) * Math.cos(t)],
    ['2t^2', 2 * t ** 2],
    ['1/2 t', t / 2],
    ['2exp(t)', 2 * Math.exp(t)],
    // e is a number, and part of one.
    ['2e', 2 * Math.E],
    ['2e-1', 0.2],
    ['2e - 1', 2 * Math.E - 1],
    ['2e3t', 2000 * t],
    ['e^t', Math.exp(t)],
    ['.5', 0.5],
    ['5.', 5],
    // As it is written in other places.
    ['t²', t ** 2],
    ['-t²', -(t ** 2)],
    ['2t⁻¹⁰', 2 * t ** -10],
    ['3 × t · 2 ÷ 4 − 1', (3 * t * 2) / 4 - 1],
    ['2（t＋１）', 2 * (t + 1)],
    ['Sin(T) + PI', Math.sin(t) + Math.PI],
    ['ln(t) - log(t)', 0],
    [
      'sqrt(t) + abs(-t) + tan(t) + asin(.5) + acos(.5) + atan(t)',
      Math.sqrt(t) + t + Math.tan(t) + Math.PI / 2 + Math.atan(t),
    ],
  ])('reads %s', (text, expected) => expect(value(text)).toBeCloseTo(expected, 13)); // rounding of numbers up to 2000

  it.each([
    ['', 1, { code: 'empty' }],
    ['2 + ', 4, { code: 'ends_early' }],
    ['sin(', 5, { code: 'ends_early' }],
    ['sin(t', 4, { code: 'not_closed' }],
    ['2 (t + (1)', 3, { code: 'not_closed' }],
    ['sin(t))', 7, { code: 'not_opened' }],
    [')', 1, { code: 'not_opened' }],
    ['2 + ()', 6, { code: 'unexpected', found: ')' }],
    ['2 $ t', 3, { code: 'unexpected', found: '$' }],
    ['π 🙂', 3, { code: 'unexpected', found: '🙂' }],
    ['3 4', 3, { code: 'unexpected', found: '4' }],
    ['t2', 2, { code: 'unexpected', found: '2' }],
    ['0,5', 2, { code: 'unexpected', found: ',' }],
    ['1.2.3', 4, { code: 'unexpected', found: '.' }],
    ['2 ** t', 4, { code: 'unexpected', found: '*' }],
    ['1 + foo(t)', 5, { code: 'unknown_name', name: 'foo' }],
    ['1 + sin(u)', 9, { code: 'unknown_name', name: 'u' }],
    ['x', 1, { code: 'unknown_name', name: 'x' }],
    ['tt', 1, { code: 'unknown_name', name: 'tt' }],
    ['constructor(t)', 1, { code: 'unknown_name', name: 'constructor' }],
    ['t + 正弦(t)', 5, { code: 'unknown_name', name: '正弦' }],
    ['2 sin t', 3, { code: 'function_without_parentheses', name: 'sin' }],
    ['2 + sin 2t', 5, { code: 'function_without_parentheses', name: 'sin' }],
    ['sin^2(t)', 1, { code: 'function_without_parentheses', name: 'sin' }],
    ['1 + sin()', 5, { code: 'wrong_number_of_arguments', name: 'sin', count: 0 }],
    ['sin(t, 2)', 1, { code: 'wrong_number_of_arguments', name: 'sin', count: 2 }],
    [`${'('.repeat(31)}t${')'.repeat(31)}`, 31, { code: 'nested_too_deep', maximum: 30 }],
    ['t+'.repeat(101), 201, { code: 'too_long', maximum: 200 }],
  ])('names the column of the mistake in “%s”', (text, column, reason) =>
    expect(parseFormula(text)).toEqual({ column, reason }),
  );

  it('says where t stands', () => {
    expect((parseFormula('2 pi sqrt(4)') as Formula).columnOfT).toBeNull();
    expect((parseFormula('tan(2) + T') as Formula).columnOfT).toBe(10);
  });

  it.each([
    ['1/2 t', String.raw`\frac{1}{2}\,t`],
    ['(t + 1)/(2t)', String.raw`\frac{t+1}{2\,t}`],
    ['-t^2', '-{t}^{2}'],
    ['(t - 1)²', String.raw`{\left(t-1\right)}^{2}`],
    ['2^(t + 1)', '{2}^{t+1}'],
    ['t - -2', String.raw`t-\left(-2\right)`],
    ['2 * -t', String.raw`2\cdot \left(-t\right)`],
    ['Sin(2πt) e', String.raw`\sin\left(2\,\pi\,t\right)\,\mathrm{e}`],
    ['sin(t)^5', String.raw`\sin^{5}\left(t\right)`],
    ['sqrt(t)²', String.raw`{\sqrt{t}}^{2}`],
    ['atan(sqrt(abs(t)))', String.raw`\arctan\left(\sqrt{\left|t\right|}\right)`],
    ['2e−3 t⁻¹', String.raw`2\cdot 10^{-3}\,{t}^{-1}`],
  ])('writes %s as it is read', (text, tex) => expect((parseFormula(text) as Formula).tex()).toBe(tex));

  it('writes nested signs as fast as it reads them', () => {
    const signs = 200 - 1; // and t: as long as a formula may be
    expect((parseFormula(`${'-'.repeat(signs)}t`) as Formula).tex()).toBe(
      `-${String.raw`\left(-`.repeat(signs - 1)}t${String.raw`\right)`.repeat(signs - 1)}`,
    );
  });

  const word = fc.constantFrom(
    't',
    'pi',
    'π',
    'e',
    'sin',
    'sqrt',
    '(',
    ')',
    '+',
    '-',
    '−',
    '*',
    '/',
    '^',
    ',',
    '.',
    '2',
    '0.5',
    '²',
    '⁻',
    ' ',
    'foo',
    'é',
    '$',
  );

  it('never throws, and every mistake has a column in the text or just behind', () => {
    fc.assert(
      fc.property(
        fc.oneof(
          fc.array(word, { maxLength: 60 }).map((words) => words.join('')),
          fc.string({ unit: 'grapheme', maxLength: 220 }),
        ),
        (text) => {
          const formula = parseFormula(text);
          if ('reason' in formula) {
            expect(formula.column).toBeGreaterThanOrEqual(1);
            expect(formula.column).toBeLessThanOrEqual([...text].length + 1);
          } else {
            expect(typeof formula.at(1)).toBe('number');
            expect(formula.tex()).not.toContain('undefined');
          }
        },
      ),
      { numRuns: 500 },
    );
  });

  it('reads what JavaScript reads alike', () => {
    const operand = fc.constantFrom('t', '2', '0.25', '(t)');
    const signed = fc.tuple(fc.constantFrom('', '-'), operand).map((parts) => parts.join(''));
    const operator = fc.constantFrom(' + ', ' - ', ' * ', ' / ');
    fc.assert(
      fc.property(signed, fc.array(fc.tuple(operator, operand), { maxLength: 8 }), (first, rest) => {
        const text = first + rest.flat().join('');
        const expected = new Function('t', `return ${text}`)(t);
        expect(value(text)).toBe(expected); // the same operations in the same order
      }),
    );
  });
});
