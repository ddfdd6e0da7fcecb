import { expect, it } from 'vitest';
import { symbolsIn } from '../../../../web/src/views/equations/symbols_in.ts';

it('finds each symbol once, in reading order, whatever stands behind its name', () => {
  expect(symbolsIn(['\\symQ\\symp = \\symb', '\\symb = \\symk\\symA^{\\mathrm T}\\symd_{ij}'])).toEqual([
    'Q',
    'p',
    'b',
    'k',
    'A',
    'd',
  ]);
});
