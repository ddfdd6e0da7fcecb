import { describe, expect, it } from 'vitest';
import { entryAt, entryMeaning } from '../../../web/src/app/entry_meaning.ts';
import type { SymbolId } from '../../../web/src/notation/symbols.ts';
import { figureOf } from '../../support/figure_of.ts';
import { chain } from '../../support/small_scenes.ts';

// Springs 0 and 1 between vertices 0, 1 and 2; vertex 0 is pinned.
const figure = figureOf(chain(3), { spring: null, vertex: null }, 1);

function meaning(id: SymbolId, row: number, column: number, value: number): string | null {
  const entry = entryAt(id, { row, column, value }, figure);
  return entry && entryMeaning(entry, figure);
}

describe('entryMeaning', () => {
  it.each([
    ['A', 1, 1, 1, '+1: spring 1 starts at vertex 1, its end i.'],
    ['A', 1, 2, -1, '−1: spring 1 ends at vertex 2, its end j.'],
    ['A', 1, 0, 0, '0: spring 1 does not touch vertex 0.'],
    ['C', 0, 0, 1, '1: this pin holds vertex 0.'],
    ['C', 0, 2, 0, '0: this pin holds vertex 0, not vertex 2.'],
    ['M', 2, 2, 1, 'The mass of vertex 2.'],
    ['Q', 0, 1, -1000, '−k: spring 0 joins vertices 0 and 1.'],
    ['Q', 2, 1, -1000, '−k: spring 1 joins vertices 2 and 1.'],
    ['Q', 0, 2, 0, '0: no spring joins vertices 0 and 2.'],
    ['E', 1, 0, 1, 'Spring 1 starts at vertex 1.'],
  ] as const)('%s(%i, %i) = %d: %s', (id, row, column, value, words) => {
    expect(meaning(id, row, column, value)).toBe(words);
  });

  it('counts the springs that add up on the diagonal of Q', () => {
    expect(meaning('Q', 1, 1, 2900)).toContain('each of its 2 springs');
    expect(meaning('Q', 2, 2, 1900)).toContain('its 1 spring,');
  });

  it('says nothing where another matrix than all of Q has a zero, nor of coordinates', () => {
    expect(meaning('Q', 0, 1, 0)).toBeNull();
    expect(meaning('p', 1, 2, 0.5)).toBeNull();
  });
});

describe('entryAt', () => {
  it('names what row and column belong to', () => {
    expect(entryAt('A', { row: 1, column: 2, value: -1 }, figure)).toMatchObject({
      row: { name: 'spring 1' },
      column: { name: 'vertex 2' },
    });
    expect(entryAt('r', { row: 1, column: 0, value: 0.5 }, figure)).toMatchObject({ column: null });
  });

  it('is nothing at a head', () => {
    expect(entryAt('A', { row: 1, column: null, value: null }, figure)).toBeNull();
  });
});
