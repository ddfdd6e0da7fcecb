import fc from 'fast-check';
import { expect, test } from 'vitest';
import type { Search } from '../../../../../web/src/app/kinematics_session.ts';
import { forwardNumbers } from '../../../../../web/src/labs/kinematics/equations/forward_numbers.ts';
import { dot, row, subtract } from '../../../../../web/src/lib/vector.ts';
import { armSearch, linksOf } from '../../../../support/arm_search.ts';

/** Rounding: a few hundred products of numbers of this size, m. */
const rounding = 1e-13;

test('a quarter turn about z at the root swings a link that hangs down to +x', () => {
  const { task, answer } = armSearch({ links: linksOf(2) });
  const search: Search = { task, answer };
  const quarter = Math.SQRT1_2;
  const q = Float64Array.of(0, 0, quarter, quarter, 0, 0, 0, 1);
  const [root, effector] = forwardNumbers(search, { x: Float64Array.of(0, 1.7, 0, 2, 1.7, 0), q });
  expect(root).toMatchObject({ length: null, link: null, axis: [0, 0, 1] });
  expect(root.angle).toBeCloseTo(Math.PI / 2, 14);
  for (const [at, entries] of [
    [0, -1, 0],
    [1, 0, 0],
    [0, 0, 1],
  ].entries())
    for (const [axis, entry] of entries.entries()) expect(root.R[at][axis]).toBeCloseTo(entry, 14);
  expect(effector).toMatchObject({ length: 2, link: [2, 0, 0], axis: null, angle: 0 });
});

test('of any pose that a search finds: x_i = x_{i−1} + R_{i−1} o_i', () => {
  fc.assert(
    fc.property(
      fc.array(fc.double({ min: 0.1, max: 2, noNaN: true }), { minLength: 1, maxLength: 8 }),
      fc.tuple(...[0, 1, 2].map(() => fc.double({ min: -2, max: 1.5, noNaN: true }))),
      fc.constantFrom('ccd', 'fabrik', 'least-squares'),
      (lengths, [x, y, z], method) => {
        const search = armSearch({ links: linksOf(...lengths), target: [x, y, z], method });
        const { x: places, q } = search.answer;
        const numbers = forwardNumbers(search, { x: places, q });
        for (const [i, { link }] of numbers.slice(1).entries()) {
          const turned = numbers[i].R.map((line) => dot(line, row(search.task.offsets, i)));
          for (const part of subtract(turned, link ?? [])) expect(Math.abs(part)).toBeLessThan(rounding);
        }
      },
    ),
  );
});
