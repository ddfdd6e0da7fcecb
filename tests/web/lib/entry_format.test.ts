import { expect, it } from 'vitest';
import { entryFormat } from '../../../web/src/lib/entry_format.ts';

function written(values: number[], unit: string | null) {
  const format = entryFormat(values, unit);
  return [format.unit, ...values.map((value) => format.write(value))];
}

it.each([
  ['signs as they are', [1, -1, 0], null, [null, '1', '−1', '0']],
  ['one scale for numbers of like size', [0.0312, -0.5, 0], 'm', ['m', '0.031', '−0.500', '0']],
  ['a unit that suits them', [0.0312, 0.001], 'm', ['mm', '31.2', '1.0']],
  ['a penalty beside a stiffness each in its own', [1e10, -100], 'N/m', ['N/m', '1.00 × 10¹⁰', '−100']],
  ['nothing but zeros', [0, 0], 'N', ['N', '0', '0']],
] as const)('writes %s', (_, values, unit, expected) => expect(written([...values], unit)).toEqual(expected));
