import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  columnScale,
  formatFixed,
  formatForce,
  formatInColumn,
  formatLength,
  formatNumber,
  formatQuantity,
  formatVector,
} from '../../../web/src/lib/format.ts';

const thin = '\u202f';
const plainDigits: Record<string, string> = { '⁻': '-' };
for (const [digit, raised] of [...'⁰¹²³⁴⁵⁶⁷⁸⁹'].entries()) plainDigits[raised] = String(digit);

/** Reads back what formatNumber wrote. */
function parse(text: string): number {
  return Number(
    text
      .replace('−', '-')
      .replace(' × 10', 'e')
      .replace(/[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]/g, (raised) => plainDigits[raised]),
  );
}

describe('formatNumber', () => {
  it.each([
    [0, '0'],
    [-0, '0'],
    [31.4159, '31.4'],
    [-25, '−25.0'],
    [9.999, '10.0'],
    [12345, '12345'],
    [0.001, '0.00100'],
    [0.00099, '9.90 × 10⁻⁴'],
    [999999.6, '1.00 × 10⁶'],
    [-1.3e10, '−1.30 × 10¹⁰'],
    [Number.POSITIVE_INFINITY, '∞'],
    [Number.NEGATIVE_INFINITY, '−∞'],
    [Number.NaN, 'NaN'],
  ])('%d → %s', (value, text) => expect(formatNumber(value)).toBe(text));

  it('keeps the digits asked for', () => {
    expect(formatNumber(2.1e-12, 2)).toBe('2.1 × 10⁻¹²');
    expect(formatNumber(Math.PI, 6)).toBe('3.14159');
  });

  it('is within half a unit of its last significant digit', () => {
    const digits = fc.integer({ min: 1, max: 10 });
    fc.assert(
      fc.property(fc.double({ noNaN: true, min: -1e300, max: 1e300 }), digits, (value, n) => {
        // 1e-15: rounding of the decimal text read back
        expect(Math.abs(parse(formatNumber(value, n)) - value)).toBeLessThanOrEqual(
          Math.abs(value) * (0.5 * 10 ** (1 - n) + 1e-15),
        );
      }),
    );
  });
});

describe('formatFixed', () => {
  it('writes no negative zero', () => {
    expect(formatFixed(-0.004, 2)).toBe('0.00');
    expect(formatFixed(-0.006, 2)).toBe('−0.01');
  });
});

describe('formatForce', () => {
  it.each([
    [0, '0\u202fN'],
    [-9.8, '−9.80\u202fN'],
    [9999, '9999\u202fN'],
    [10000, '10.0\u202fkN'],
    [833587, '834\u202fkN'],
  ])('%d N → %s', (newtons, text) => expect(formatForce(newtons)).toBe(text));
});

describe('formatQuantity and formatLength', () => {
  it('put a thin space before the unit', () => expect(formatQuantity(-9.8, 'N')).toBe(`−9.80${thin}N`));

  it.each([
    [1.25, `1.25${thin}m`],
    [0.0312, `31.2${thin}mm`],
    [-4e-6, `−4.00${thin}µm`],
    [2e-12, `2.00 × 10⁻¹²${thin}m`],
    [0, `0${thin}m`],
  ])('%d m → %s', (metres, text) => expect(formatLength(metres)).toBe(text));
});

describe('columnScale', () => {
  it('shows a rest length of 25 mm with four digits, and every other length in line with it', () => {
    const scale = columnScale(0.025, 'm');
    expect(scale).toEqual({ unit: 'mm', factor: 1000, decimals: 2 });
    expect([0.025, -0.1234567, 0].map((x) => formatInColumn(x, scale))).toEqual(['25.00', '−123.46', '0.00']);
  });

  it('takes a common power of ten for large forces', () => {
    const scale = columnScale(1.3e10, 'N');
    expect(scale.unit).toBe(`10⁹${thin}N`);
    expect(formatInColumn(-1.3e10, scale)).toBe('−13.00');
  });

  it('never asks for more decimals than toFixed has, whatever the reference', () => {
    fc.assert(
      fc.property(fc.double({ noNaN: true, min: 0, max: 1e300 }), fc.constantFrom('m', 'N'), (reference, unit) => {
        fc.pre(reference === 0 || reference > 1e-300);
        expect(formatInColumn(0, columnScale(reference, unit))).toMatch(/^0(\.0+)?$/);
      }),
    );
  });
});

describe('formatVector', () => {
  it('writes all components in the scale of the largest', () => {
    expect(formatVector([0.12, -9.8, 0], 'N')).toBe(`(0.12, −9.80, 0.00)${thin}N`);
    expect(formatVector([0.0312, 0, 0.001], 'm')).toBe(`(31.2, 0.0, 1.0)${thin}mm`);
  });
});
