import { afterEach, describe, expect, it } from 'vitest';
import { highlighted, nothing } from '../../../../web/src/app/highlight.ts';
import { matrixCells } from '../../../../web/src/views/matrices/matrix_cells.ts';
import { figureOf } from '../../../support/figure_of.ts';
import { chain } from '../../../support/small_scenes.ts';

// Springs 0 and 1 between vertices 0, 1 and 2; vertex 0 is pinned.
const figure = figureOf(chain(3), { spring: 1, vertex: null }, 1);
const A = [1, -1, 0, 0, 1, -1];
const Q = [2, -1, 0, -1, 3, -1, 0, -1, 2];
const cells = (id: 'A' | 'Q' | 'C' | 'r', values: number[]) => matrixCells(id, values, String, figure);
const lit = (table: ReturnType<typeof cells>) => table.map((row) => row.map(({ isLit }) => Number(isLit)));

afterEach(() => {
  highlighted.value = nothing;
});

describe('matrixCells', () => {
  it('puts heads before the entries', () => {
    expect(cells('A', A).map((row) => row.map(({ text }) => text))).toEqual([
      ['', '0', '1', '2'],
      ['0', '1', '-1', '0'],
      ['1', '0', '1', '-1'],
    ]);
  });

  it('numbers the rows of C by the vertices that are pinned, and leaves the column of a vector without a head', () => {
    expect(cells('C', [1, 0, 0])[1][0].things).toEqual({ spring: null, vertex: 0 });
    expect(cells('r', [0.5, 0.5])[0].map(({ text }) => text)).toEqual(['', '']);
  });

  it('reads out of every entry where it stands', () => {
    expect(cells('A', A)[2][3].label).toBe('A, spring 1, vertex 2: -1');
    expect(cells('r', [0.5, 0.5])[2][1].label).toBe('r, spring 1: 0.5');
  });

  it('says of every entry and head where it stands, counted in the matrix itself', () => {
    const table = cells('A', A);
    expect(table[2][3].place).toEqual({ row: 1, column: 2, value: -1 });
    expect(table[0][3].place).toEqual({ row: null, column: 2, value: null });
    expect(table[2][0].place).toEqual({ row: 1, column: null, value: null });
  });

  it('gives an entry of A its spring and its vertex', () => {
    expect(cells('A', A)[2][3].things).toEqual({ spring: 1, vertex: 2 });
  });

  it('gives the diagonal of Q to the vertices, what is not zero beside it to the springs', () => {
    const [, first] = cells('Q', Q);
    expect(first.slice(1).map(({ things }) => things)).toEqual([
      { spring: null, vertex: 0 },
      { spring: 0, vertex: null },
      { spring: null, vertex: null },
    ]);
  });

  it('lights row e of A when d is pointed at and e is selected', () => {
    highlighted.value = { ...nothing, symbols: ['d'], figure };
    expect(lit(cells('A', A))).toEqual([
      [0, 0, 0, 0],
      [0, 0, 0, 0],
      [1, 1, 1, 1],
    ]);
  });

  it('lights row and column of a vertex, and the two entries of a spring', () => {
    highlighted.value = { ...nothing, figure, vertex: 1 };
    expect(lit(cells('Q', Q))).toEqual([
      [0, 0, 1, 0],
      [0, 0, 1, 0],
      [1, 1, 1, 1],
      [0, 0, 1, 0],
    ]);
    highlighted.value = { ...nothing, figure, spring: 0 };
    expect(lit(cells('Q', Q))).toEqual([
      [0, 0, 0, 0],
      [0, 0, 1, 0],
      [0, 1, 0, 0],
      [0, 0, 0, 0],
    ]);
  });
});
