import { expect, it } from 'vitest';
import { formatBytes } from '../../../web/src/lib/format_bytes.ts';

it('takes the unit that suits', () => {
  expect([12, 3046, 94_100_000, 2e9].map(formatBytes)).toEqual([
    '12\u202fB',
    '3.05\u202fkB',
    '94.1\u202fMB',
    '2.00\u202fGB',
  ]);
});
