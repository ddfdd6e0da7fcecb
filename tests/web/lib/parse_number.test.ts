import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { parseNumber } from '../../../web/src/lib/parse_number.ts';

describe('parseNumber', () => {
  it('reads every finite number as JavaScript writes it', () => {
    fc.assert(
      fc.property(fc.double({ noNaN: true, noDefaultInfinity: true }), (x) => {
        expect(parseNumber(String(x))).toBe(x + 0 === 0 ? 0 : x);
      }),
    );
  });

  it.each([
    ['1/30', 1 / 30],
    [' 3e2 ', 300],
    ['1 / 4', 0.25],
    ['−2.5', -2.5],
    ['３００', 300],
    ['.5', 0.5],
  ])('reads %s', (text, value) => expect(parseNumber(text)).toBe(value));

  it.each(['', ' ', 'abc', '1/0', '1/', '/2', '1/2/3', 'NaN', 'Infinity', '1e999', '1,5', '0x10', '5 m'])(
    'refuses “%s”',
    (text) => expect(parseNumber(text)).toBeNull(),
  );

  it('reads a number with its unit', () => {
    expect(parseNumber('300 N/m', 'N/m')).toBe(300);
    expect(parseNumber('1/30 s', 's')).toBe(1 / 30);
  });
});
