import { expect, it } from 'vitest';
import { meaningOf } from '../../../web/src/app/pointing.ts';

it.each([
  [{ sym: 'd' }, { symbols: ['d'], spring: null, vertex: null }],
  [
    { about: 'A', spring: '0', vertex: '12' },
    { symbols: ['A'], spring: 0, vertex: 12 },
  ],
  [{ about: 'd r unheardof' }, { symbols: ['d', 'r'], spring: null, vertex: null }],
  [{ vertex: '3' }, { symbols: [], spring: null, vertex: 3 }],
] as const)('an element with %j stands for %j', (dataset, meaning) => {
  expect(meaningOf(dataset)).toEqual(meaning);
});
