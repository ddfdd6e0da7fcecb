import { expect, it } from 'vitest';
import { asRanges } from '../../../web/src/lib/as_ranges.ts';

it.each([
  [[], ''],
  [[4], '4'],
  [[4, 5], '4, 5'],
  [[4, 5, 6], '4–6'],
  [[1, 3, 4, 5, 6, 9, 10], '1, 3–6, 9, 10'],
] as const)('%j → %s', (numbers, text) => expect(asRanges(numbers)).toBe(text));
