import { describe, expect, it } from 'vitest';
import { cholesky } from '../../../../../../web/src/labs/lesson/sections/solving/cholesky.ts';
import { nonZeros, smallMatrix } from '../../../../../../web/src/labs/lesson/sections/solving/small_matrix.ts';
import {
  factorPattern,
  minimumDegreeOrder,
  naturalOrder,
  patternOf,
} from '../../../../../../web/src/labs/lesson/sections/sparse/fill_in.ts';
import { sceneParameters } from '../../../../../../web/src/solver/scene_parameters.ts';
import { openScene } from '../../../../../support/open_scene.ts';
import { openSimulation } from '../../../../../support/open_simulation.ts';

describe('a hub with four spokes', () => {
  const hubFirst = patternOf(5, [0, 1, 0, 2, 0, 3, 0, 4]);

  it('ties all spokes to each other when the hub goes first', () => {
    expect(factorPattern(hubFirst, [0, 1, 2, 3, 4]).filled).toHaveLength(6);
  });

  it('fills nothing when the hub goes after the spokes, as the rule has it', () => {
    expect(factorPattern(hubFirst, minimumDegreeOrder(hubFirst)).filled).toEqual([]);
  });
});

it('fills one entry of a square: the diagonal opposite to the first vertex', () => {
  const square = patternOf(4, [0, 1, 1, 2, 2, 3, 3, 0]);
  expect(factorPattern(square, naturalOrder(square)).filled).toEqual([[3, 1]]);
});

describe('the net', async () => {
  const scene = await openScene('net');
  const pattern = patternOf(scene.m.length, scene.E);

  it('predicts every entry of its L', () => {
    const { kept, filled } = factorPattern(pattern, naturalOrder(pattern));
    const diagonal = pattern.map((_, i) => [i, i]);
    const factor = cholesky(smallMatrix(openSimulation(scene, sceneParameters(scene)).Q()));
    if (!('L' in factor)) throw new Error('Q is positive definite');
    expect(new Set([...diagonal, ...kept, ...filled].map(String))).toEqual(new Set(nonZeros(factor.L).map(String)));
  });

  it('fills less than half as much with fewest neighbours first', () => {
    const order = minimumDegreeOrder(pattern);
    expect([...order].sort((a, b) => a - b)).toEqual(naturalOrder(pattern));
    const filled = (of: number[]) => factorPattern(pattern, of).filled.length;
    expect(filled(order)).toBeLessThan(filled(naturalOrder(pattern)) / 2);
  });
});
