import { expect, it } from 'vitest';
import { tokenize } from '../../../../web/src/views/code/tokenize.ts';

it('tells keywords, names, numbers and comments apart', () => {
  const tokens = tokenize('  const double x = 0.5 / r(e);  // m, not 3').filter(({ text }) => text.trim() !== '');
  expect(tokens.map(({ kind, text }) => `${kind} ${text.trim()}`)).toEqual([
    'keyword const',
    'keyword double',
    'name x',
    'other =',
    'number 0.5',
    'other /',
    'name r',
    'other (',
    'name e',
    'other );',
    'comment // m, not 3',
  ]);
});
