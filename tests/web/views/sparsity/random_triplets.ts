import fc from 'fast-check';
import type { Triplets } from '../../../../web/src/solver/module.ts';

/** Sparse matrices in any order of their entries, each place at most once, none of them zero. */
export const triplets = fc
  .record({ rows: fc.integer({ min: 1, max: 40 }), columns: fc.integer({ min: 1, max: 40 }) })
  .chain(({ rows, columns }) =>
    fc
      .uniqueArray(fc.record({ i: fc.nat(rows - 1), j: fc.nat(columns - 1), value: fc.integer({ min: -9, max: 9 }) }), {
        selector: ({ i, j }) => i * columns + j,
        maxLength: 120,
      })
      .map((entries): Triplets => {
        const present = entries.filter(({ value }) => value !== 0);
        return {
          rows,
          columns,
          i: Int32Array.from(present, ({ i }) => i),
          j: Int32Array.from(present, ({ j }) => j),
          value: Float64Array.from(present, ({ value }) => value),
        };
      }),
  );
