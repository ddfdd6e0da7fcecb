import { expect, it } from 'vitest';
import { moveInGrid } from '../../../web/src/lib/move_in_grid.ts';

// Rows of 3, 1 and 2 cells.
it.each([
  ['ArrowRight', [0, 1], [0, 2]],
  ['ArrowRight', [0, 2], [0, 2]], // no further than the edge
  ['ArrowLeft', [0, 0], [0, 0]],
  ['ArrowDown', [0, 2], [1, 0]], // into the last cell of a shorter row
  ['ArrowDown', [2, 1], [2, 1]],
  ['ArrowUp', [2, 1], [1, 0]],
  ['Home', [0, 2], [0, 0]],
  ['End', [2, 0], [2, 1]],
] as const)('%s leads from %j to %j', (key, [row, column], [nextRow, nextColumn]) => {
  expect(moveInGrid(key, { row, column }, [3, 1, 2])).toEqual({ row: nextRow, column: nextColumn });
});

it('leaves other keys alone', () => {
  expect(moveInGrid('Enter', { row: 0, column: 0 }, [3])).toBeNull();
});
