import { describe, expect, it } from 'vitest';
import { sizeOf, symbolValue } from '../../../web/src/app/symbol_value.ts';
import { figureOf } from '../../support/figure_of.ts';
import { chain } from '../../support/small_scenes.ts';

// Vertices at x = 0, 0.5 and 1 m, one spring between neighbours, the first vertex pinned; at rest, so predict and the first local step move nothing.
const selection = { spring: 1, vertex: 0 };

describe('symbolValue', () => {
  const figure = figureOf(chain(3), selection, 1);

  it.each([
    ['springCount', '2'],
    ['k', '1000\u202fN/m'],
    ['E', '(1, 2)'],
    ['r', '0.500\u202fm'],
    ['v', '(−0.500, 0.000, 0.000)\u202fm'],
    ['d', '(−0.500, 0.000, 0.000)\u202fm'],
    ['pTarget', '(0.00, 0.00, 0.00)\u202fm'],
    ['potential', '0\u202fJ'],
  ] as const)('%s is %s', (id, value) => expect(symbolValue(id, figure, selection)).toBe(value));

  it('is the row asked for, whatever is selected', () => {
    expect(symbolValue('p', figure, { spring: null, vertex: 2 })).toBe('(1.00, 0.00, 0.00)\u202fm');
  });

  // At rest, with gravity the only external force on 1 kg.
  it.each([
    ['pCurr', '(1.00, 0.00, 0.00)\u202fm'],
    ['pPrev', '(1.00, 0.00, 0.00)\u202fm'],
    ['velocity', '(0.00, 0.00, 0.00)\u202fm/s'],
    ['fExt', '(0.00, −9.80, 0.00)\u202fN'],
  ] as const)('%s, known of every vertex, is %s', (id, value) =>
    expect(symbolValue(id, figure, { spring: null, vertex: 2 })).toBe(value),
  );

  it('says nothing of a spring that nobody named, of the target of a free vertex, of whole matrices', () => {
    expect(symbolValue('d', figure, { spring: null, vertex: 0 })).toBeNull();
    expect(symbolValue('pTarget', figure, { spring: null, vertex: 2 })).toBeNull();
    expect(symbolValue('Q', figure, selection)).toBeNull();
  });

  it('knows neither d nor b at predict', () => {
    const atPredict = figureOf(chain(3), selection, 0);
    expect(symbolValue('d', atPredict, selection)).toBeNull();
    expect(symbolValue('b', atPredict, selection)).toBeNull();
    expect(symbolValue('y', atPredict, selection)).not.toBeNull();
  });
});

describe('sizeOf', () => {
  it('counts what the shape names', () => {
    const figure = figureOf(chain(3), selection, 0);
    expect(sizeOf('A', figure)).toBe('2 × 3');
    expect(sizeOf('C', figure)).toBe('1 × 3');
    expect(sizeOf('k', figure)).toBe('');
  });
});
