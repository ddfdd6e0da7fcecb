import { expect, it } from 'vitest';
import { formatBytes } from '../../../web/src/lib/format_bytes.ts';

it('takes the unit that suits', () => {
  expect([12, 3046, 94_100_000, 2e9].map(formatBytes)).toEqual([
    '12\u2009B',
    '3.05\u2009kB',
    '94.1\u2009MB',
    '2.00\u2009GB',
  ]);
});
