import { expect, it } from 'vitest';
import { nothing } from '../../../web/src/app/highlight.ts';
import { meaningOf } from '../../../web/src/app/pointing.ts';

it.each([
  [{ sym: 'd' }, { ...nothing, symbols: ['d'] }],
  [
    { about: 'A', spring: '0', vertex: '12', row: '0', column: '12', value: '-1' },
    { ...nothing, symbols: ['A'], spring: 0, vertex: 12, place: { row: 0, column: 12, value: -1 } },
  ],
  [
    { about: 'p', column: '2' },
    { ...nothing, symbols: ['p'], place: { row: null, column: 2, value: null } },
  ],
  [
    { about: 'd r', line: 'local_step.cpp 11' },
    { ...nothing, symbols: ['d', 'r'], line: { file: 'local_step.cpp', number: 11 } },
  ],
  [{ about: 'd r unheardof' }, { ...nothing, symbols: ['d', 'r'] }],
  [{ vertex: '3' }, { ...nothing, vertex: 3 }],
] as const)('an element with %j stands for %j', (dataset, meaning) => {
  expect({ ...meaningOf(dataset), figure: null }).toEqual(meaning);
});
