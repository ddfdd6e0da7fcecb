import { describe, expect, it } from 'vitest';
import {
  cholesky,
  inverse,
  substituteBackwards,
  substituteForwards,
} from '../../../../../../web/src/labs/lesson/sections/solving/cholesky.ts';
import { nonZeros, smallMatrix } from '../../../../../../web/src/labs/lesson/sections/solving/small_matrix.ts';
import { sceneParameters } from '../../../../../../web/src/solver/scene_parameters.ts';
import { openScene } from '../../../../../support/open_scene.ts';
import { distance, expectOk, openSimulation } from '../../../../../support/open_simulation.ts';

// By hand: L = [[2, 0, 0], [1, 2, 0], [−1, 1, 3]].
const Q = [
  [4, 2, -2],
  [2, 5, 1],
  [-2, 1, 11],
];
const L = [
  [2, 0, 0],
  [1, 2, 0],
  [-1, 1, 3],
];

describe('by hand', () => {
  it('finds the triangle', () => {
    expect(cholesky(Q)).toEqual({ L });
  });

  it('solves downwards and upwards', () => {
    expect(substituteForwards(L, [2, 5, 10])).toEqual([1, 2, 3]);
    expect(substituteBackwards(L, [1, 2, 3])).toEqual([0.75, 0.5, 1]);
  });

  it('says at which row there is no triangle', () => {
    expect(
      cholesky([
        [1, 2],
        [2, 1],
      ]),
    ).toEqual({ failedAt: 1, pivot: -3 });
  });
});

describe('the net, as the lesson claims', async () => {
  const scene = await openScene('net');
  const parameters = { ...sceneParameters(scene), w: 1000, path: 'plain' as const };
  const seen = () => {
    const simulation = openSimulation(scene, parameters);
    expectOk(simulation.seek(2));
    const factor = cholesky(smallMatrix(simulation.Q()));
    if (!('L' in factor)) throw new Error('Q is positive definite');
    return { simulation, L: factor.L };
  };

  it('gives the positions of the solver', () => {
    const { simulation, L } = seen();
    const heights = (p: Float64Array) => Float64Array.from({ length: L.length }, (_, i) => p[3 * i + 1]);
    const b = L.map((_, i) => simulation.probe_vertex(i).b[1]);
    const p = substituteBackwards(L, substituteForwards(L, b));
    // Metres; both round, in a different order, in about 60 operations a row of a matrix whose condition number is below 10.
    expect(distance(Float64Array.from(p), heights(simulation.p()))).toBeLessThan(1e-13);
  });

  it('has an inverse without a zero, and a triangle with many', () => {
    const { simulation, L } = seen();
    expect(nonZeros(inverse(L))).toHaveLength(61 ** 2);
    expect(nonZeros(L).length).toBeLessThan(61 ** 2 / 4);
    expect(simulation.Q().value).toHaveLength(61 + 2 * 120);
  });
});
