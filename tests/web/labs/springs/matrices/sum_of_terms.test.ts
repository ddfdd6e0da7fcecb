import { expect, it } from 'vitest';
import { sumOfTerms, termAt, termPatterns, terms } from '../../../../../web/src/labs/springs/matrices/sum_of_terms.ts';
import { readMatrices } from '../../../../../web/src/solver/read_matrices.ts';
import { openSimulation } from '../../../../support/open_simulation.ts';
import { net, usualParameters } from '../../../../support/small_scenes.ts';

const scene = net(4);

function opened() {
  const matrices = readMatrices(openSimulation(scene, { ...usualParameters, w: 1e4 }));
  return { Q: matrices.Q, patterns: termPatterns(matrices) };
}

it('all three terms are Q', () => {
  const { Q, patterns } = opened();
  const { sum } = sumOfTerms(Q, patterns, terms);
  expect(sum.i).toEqual(Q.i);
  expect(sum.j).toEqual(Q.j);
  // Three numbers added up, in whatever order: a few roundings of the largest.
  sum.value.forEach((value, at) => {
    expect(Math.abs(value - Q.value[at])).toBeLessThan(1e-15 * 4 * Math.abs(Q.value[at]) + 1e-10);
  });
});

it('masses alone are a diagonal, and every entry says which terms it comes from', () => {
  const { Q, patterns } = opened();
  const masses = sumOfTerms(Q, patterns, ['masses']);
  expect(masses.sum.i).toEqual(masses.sum.j);
  expect(masses.sum.i).toHaveLength(scene.m.length);
  const all = sumOfTerms(Q, patterns, terms);
  all.from.forEach((bits, at) => {
    const [row, column] = [Q.i[at], Q.j[at]];
    const pinned = row === column && scene.pinned.includes(row);
    expect(bits).toBe(1 + (row === column ? 2 : 0) + (pinned ? 4 : 0));
  });
  expect(termAt(patterns, 'pins', { row: scene.pinned[0], column: scene.pinned[0] })).toBe(1e4);
});

it('no term is nothing', () => {
  const { Q, patterns } = opened();
  expect(sumOfTerms(Q, patterns, []).sum.value).toHaveLength(0);
});
