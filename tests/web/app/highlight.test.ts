import { afterEach, describe, expect, it } from 'vitest';
import {
  areAllLit,
  type Highlight,
  highlighted,
  litSymbols,
  litThings,
  nothing,
} from '../../../web/src/app/highlight.ts';
import { figureOf } from '../../support/figure_of.ts';
import { chain } from '../../support/small_scenes.ts';

const figure = figureOf(chain(4), { spring: 2, vertex: 1 }, 0);
const other = figureOf(chain(4), { spring: null, vertex: 3 }, 0);
const point = (at: Partial<Highlight>) => {
  highlighted.value = { ...nothing, ...at };
};

afterEach(() => point({}));

describe('a symbol pointed at', () => {
  it('lights itself, all springs when it has a row for each, and the selected one', () => {
    point({ symbols: ['d'], figure });
    expect(litSymbols.value).toEqual(['d']);
    expect(areAllLit('spring')).toBe(true);
    expect(areAllLit('vertex')).toBe(false);
    expect(litThings(figure)).toEqual({ spring: 2, vertex: null });
  });

  it('lights both kinds when it has rows for one and columns for the other', () => {
    point({ symbols: ['A'], figure });
    expect(litThings(figure)).toEqual({ spring: 2, vertex: 1 });
  });

  it('in running text is about every figure, in a figure about that one', () => {
    point({ symbols: ['p'] });
    expect(litThings(other)).toEqual({ spring: null, vertex: 3 });
    point({ symbols: ['p'], figure });
    expect(litThings(other)).toEqual({ spring: null, vertex: null });
  });

  it('can be left out where a picture draws something else', () => {
    point({ symbols: ['v'], figure });
    expect(areAllLit('spring', 'd')).toBe(true);
    expect(areAllLit('spring', 'v')).toBe(false);
  });

  it('that is a single number lights no thing', () => {
    point({ symbols: ['k'], figure });
    expect(litThings(figure)).toEqual({ spring: null, vertex: null });
  });
});

describe('a spring or vertex pointed at', () => {
  it('lights the symbols that have a row or column for it', () => {
    point({ figure, spring: 0 });
    expect(litSymbols.value).toEqual(expect.arrayContaining(['E', 'r', 'd', 'v', 'A']));
    expect(litSymbols.value).not.toContain('p');
    point({ figure, vertex: 0 });
    expect(litSymbols.value).toEqual(expect.arrayContaining(['A', 'M', 'Q', 'C', 'p', 'y', 'b']));
    expect(litSymbols.value).not.toContain('d');
  });

  it('is lit in its own figure alone, instead of the selected one', () => {
    point({ figure, spring: 0 });
    expect(litThings(figure)).toEqual({ spring: 0, vertex: null });
    expect(litThings(other)).toEqual({ spring: null, vertex: null });
    expect(areAllLit('spring')).toBe(false);
  });

  it('as an entry of a matrix lights that matrix’s symbol, its row and its column', () => {
    point({ symbols: ['A'], figure, spring: 0, vertex: 1 });
    expect(litSymbols.value).toEqual(['A']);
    expect(litThings(figure)).toEqual({ spring: 0, vertex: 1 });
  });
});

it('nothing pointed at lights nothing', () => {
  expect(litSymbols.value).toEqual([]);
  expect(litThings(figure)).toEqual({ spring: null, vertex: null });
});
