import { expect, it } from 'vitest';
import { freeVertices } from '../../../../../web/src/labs/springs/matrices/numbering.ts';
import {
  constrainedTo,
  placesOfSprings,
  sumOfSprings,
} from '../../../../../web/src/labs/springs/matrices/sum_of_springs.ts';
import { type Stage, summandsOf } from '../../../../../web/src/labs/springs/matrices/summands_of.ts';
import type { Triplets } from '../../../../../web/src/solver/module.ts';
import { readLinearlyImplicit } from '../../../../../web/src/solver/read_linearly_implicit.ts';
import { dense } from '../../../../support/dense.ts';
import { distance, expectOk, openSimulation } from '../../../../support/open_simulation.ts';
import { net, usualParameters } from '../../../../support/small_scenes.ts';

const scene = net(4);
const parameters = { ...usualParameters, damping: 2, path: 'fast' } as const;
const springs = scene.E.length / 2;

/** After some time steps, when no spring is along an axis any more. */
function opened() {
  const simulation = openSimulation(scene, parameters);
  for (let step = 0; step < 5; step++) expectOk(simulation.step());
  const read = readLinearlyImplicit(simulation);
  const places = placesOfSprings(read.system, scene.E);
  const sum = (stage: Stage, count: number) =>
    sumOfSprings({ ...summandsOf(stage, read, scene.m, parameters.delta_t), matrix: read.system, places }, count);
  return { read, sum };
}

function expectClose(sum: Triplets, solver: Triplets) {
  expect([sum.rows, sum.columns, [...sum.i], [...sum.j]]).toEqual([
    solver.rows,
    solver.columns,
    [...solver.i],
    [...solver.j],
  ]);
  // Up to eight springs at a vertex, added in another order.
  const largest = solver.value.reduce((most, entry) => Math.max(most, Math.abs(entry)), 0);
  expect(distance(sum.value, solver.value)).toBeLessThan(1e-14 * largest);
}

it('comes to the solver’s matrices once all springs are added', () => {
  const { read, sum } = opened();
  expectClose(sum('K', springs).sum, read.K);
  expectClose(sum('system', springs).sum, read.system);
  expectClose(
    constrainedTo(freeVertices({ vertexCount: 16, pinned: scene.pinned }), sum('constrained', springs)).sum,
    read.constrained,
  );
});

it('begins with nothing, or with the masses', () => {
  const { sum } = opened();
  expect(sum('K', 0).sum.value).toHaveLength(0);
  const masses = sum('system', 0);
  expect(masses.sum.i).toEqual(masses.sum.j);
  expect([...masses.sum.value]).toEqual(new Array(48).fill(1));
  expect(masses.latest.every((is) => is === 0)).toBe(true);
});

it('adds one spring’s four blocks at a time, and says which entries they are', () => {
  const { read, sum } = opened();
  const e = 5;
  const [i, j] = [scene.E[2 * e], scene.E[2 * e + 1]];
  const [before, after] = [dense(sum('K', e).sum), dense(sum('K', e + 1).sum)];
  const { latest, sum: now } = sum('K', e + 1);
  expect(latest.reduce((count, is) => count + is, 0)).toBe(36);
  now.value.forEach((_, at) => {
    const ends = [Math.floor(now.i[at] / 3), Math.floor(now.j[at] / 3)];
    expect(latest[at] === 1).toBe(ends.every((end) => end === i || end === j));
  });
  const H = read.stiffness.subarray(9 * e, 9 * e + 9);
  for (let at = 0; at < 9; at++) {
    const [row, column] = [Math.floor(at / 3), at % 3];
    // Differences of sums of at most eight blocks.
    const added = (a: number, b: number) => after[3 * a + row][3 * b + column] - before[3 * a + row][3 * b + column];
    expect(added(i, i)).toBeCloseTo(-H[at], 9);
    expect(added(j, j)).toBeCloseTo(-H[at], 9);
    expect(added(i, j)).toBeCloseTo(H[at], 9);
    expect(added(j, i)).toBeCloseTo(H[at], 9);
  }
});

it('leaves nothing of the rows and columns of pinned vertices', () => {
  const { sum } = opened();
  const free = freeVertices({ vertexCount: 16, pinned: scene.pinned });
  expect([...free]).toEqual([1, 2, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15]);
  const all = dense(sum('system', springs).sum);
  const kept = dense(constrainedTo(free, sum('system', springs)).sum);
  const coordinates = [...free].flatMap((vertex) => [3 * vertex, 3 * vertex + 1, 3 * vertex + 2]);
  expect(kept).toEqual(coordinates.map((row) => coordinates.map((column) => all[row][column])));
});
