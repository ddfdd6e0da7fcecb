import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compareStorage } from '../../web/src/solver/compare_storage.ts';
import { readElimination, readEliminationStep } from '../../web/src/solver/eliminations.ts';
import type { EliminatedEntries } from '../../web/src/solver/matrices.ts';
import { orderings, type Simulation } from '../../web/src/solver/module.ts';
import { readMatrices } from '../../web/src/solver/read_matrices.ts';
import { dense, rowSums } from '../support/dense.ts';
import { openScene } from '../support/open_scene.ts';
import { openMoving, openSimulation, place } from '../support/open_simulation.ts';
import { chain, movingScenes, net, usualParameters } from '../support/small_scenes.ts';

const entriesAfter = (simulation: Simulation, columns: number): EliminatedEntries => {
  const outcome = readEliminationStep(simulation, { ordering: 'natural', columns });
  if (!outcome.ok) throw new Error(outcome.status.code);
  return outcome.value.entries;
};

describe('the matrices', () => {
  it('of any scene: Q is the sum of its terms, and AᵀA knows nothing of moving all vertices alike', () => {
    fc.assert(
      fc.property(movingScenes, (scene) => {
        const simulation = openMoving(scene);
        const { Q, AtA, terms, ...rest } = readMatrices(simulation);
        const [springs, masses, pins] = [terms.springs, terms.masses, terms.pins].map(dense);
        expect(rowSums(AtA).every((sum) => sum === 0)).toBe(true);
        dense(Q).forEach((row, i) => {
          row.forEach((entry, j) => {
            const sum = springs[i][j] + masses[i][j] + pins[i][j];
            // A diagonal entry adds up to eleven numbers in another order.
            expect(Math.abs(entry - sum)).toBeLessThanOrEqual(11 * 2.3e-16 * Math.abs(entry));
          });
        });
        expect(Q).toEqual(simulation.Q());
        for (const name of ['A', 'M', 'C'] as const) expect(rest[name]).toEqual(simulation[name]());
      }),
      { seed: 3, numRuns: 50 },
    );
  });

  it('say which vertices are unknowns: all, or on the fast path those that are not pinned', () => {
    const scene = net(3); // pinned: 0 and 2
    expect([...readMatrices(openSimulation(scene, usualParameters)).unknowns]).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8]);
    const fast = openSimulation(scene, { ...usualParameters, path: 'fast' });
    expect([...readMatrices(fast).unknowns]).toEqual([1, 3, 4, 5, 6, 7, 8]);
  });
});

describe('the elimination', () => {
  it('of any scene, in any order, on either path: L Lᵀ = P Q Pᵀ', () => {
    fc.assert(
      fc.property(
        movingScenes,
        fc.constantFrom('fast', 'plain'),
        fc.constantFrom(...orderings),
        (scene, path, ordering) => {
          const simulation = openMoving({ ...scene, parameters: { ...scene.parameters, path } });
          const { order, factor, nonzeros, counts, parent, fill } = readElimination(simulation, ordering);
          if (!factor) throw new Error('a small scene takes few flops');
          expect([...order].sort((a, b) => a - b)).toEqual([...readMatrices(simulation).unknowns]);
          const Q = dense(simulation.Q());
          const L = dense(factor);
          L.forEach((row, i) => {
            for (let j = 0; j <= i; j++) {
              const product = row.reduce((sum, value, c) => sum + value * L[j][c], 0);
              const entry = Q[order[i]][order[j]];
              // Sums of up to ten products, each at most the root of two diagonal entries of Q.
              const size = Math.sqrt(Q[order[i]][order[i]] * Q[order[j]][order[j]]);
              expect(Math.abs(product - entry)).toBeLessThan(20 * 2.3e-16 * size);
            }
          });
          expect(factor.value).toHaveLength(nonzeros);
          expect(factor.born.filter((born) => born > 0)).toHaveLength(fill);
          expect(counts.reduce((sum, count) => sum + count, 0)).toBe(nonzeros);
          parent.forEach((row, c) => {
            const below = factor.i.filter((i, t) => factor.j[t] === c && i > c);
            expect(row).toBe(below.length > 0 ? below[0] : -1);
          });
        },
      ),
      { seed: 4, numRuns: 20 }, // each is also timed, for some 50 ms
    );
  });

  it('goes forwards and backwards and finds every entry again, bit for bit', () => {
    const simulation = openSimulation(net(4), usualParameters);
    const forwards = Array.from({ length: 17 }, (_, columns) => entriesAfter(simulation, columns));
    for (let columns = 16; columns >= 0; columns--)
      expect(entriesAfter(simulation, columns)).toEqual(forwards[columns]);
    const { milliseconds: _, ...L } = readElimination(simulation, 'natural').factor ?? { milliseconds: 0 };
    expect(forwards[16]).toEqual(L);
  });

  it('starts from Q, whose entries are not fill-in', () => {
    const simulation = openSimulation(net(4), usualParameters);
    const start = entriesAfter(simulation, 0);
    const Q = dense(simulation.Q());
    expect(dense(start)).toEqual(Q.map((row, i) => row.map((value, j) => (j <= i ? value : 0))));
    expect(start.born.every((born) => born === 0)).toBe(true);
  });

  it('of a chain from its end makes no fill-in, and every column hangs from the next', () => {
    const { fill, parent, flops } = readElimination(openSimulation(chain(5), usualParameters), 'natural');
    expect(fill).toBe(0);
    expect([...parent]).toEqual([1, 2, 3, 4, -1]);
    expect(flops).toBe(4 * 2 ** 2 + 1);
  });

  it('in the solver’s order is the one of Eigen on the plain path', () => {
    const simulation = openSimulation(net(6), usualParameters);
    expect(simulation.order('solver')).toEqual(simulation.order('minimum-degree'));
  });

  it('of the flag needs the less fill-in the better the order', async () => {
    const simulation = openSimulation(await openScene('flag'), { ...usualParameters, path: 'fast' });
    const [natural, degree, solvers] = orderings.map((ordering) => readElimination(simulation, ordering));
    expect(degree.fill).toBeLessThan(natural.fill / 2);
    expect(solvers.fill).toBeLessThanOrEqual(degree.fill);
    expect(natural.nonzerosOfQ).toBe(degree.nonzerosOfQ);
  });

  it('refuses a column that is not there, by its number', () => {
    const simulation = openSimulation(chain(3), usualParameters);
    expect(readEliminationStep(simulation, { ordering: 'natural', columns: 4 })).toMatchObject({
      ok: false,
      status: { code: 'index_out_of_range', field: 'columns', value: 4 },
    });
  });
});

describe('storage', () => {
  it('is compared in bytes and in time', () => {
    const { n, dense, sparse } = compareStorage(openSimulation(net(10), usualParameters));
    expect(n).toBe(100);
    expect(dense).toMatchObject({ bytesOfQ: 8 * 100 ** 2, bytesOfL: 8 * 100 ** 2 });
    // 90 + 90 + 81 springs, an entry on either side of the diagonal; a number and a row each.
    expect(sparse.bytesOfQ).toBe(12 * (100 + 2 * 261));
    expect(sparse.bytesOfL).toBeGreaterThan(12 * (100 + 261));
    for (const { factorise, substitute } of [dense, sparse]) {
      expect(factorise).toBeGreaterThan(0);
      expect(substitute).toBeGreaterThan(0);
    }
  });

  it('of nothing, since all vertices are pinned, costs nothing', () => {
    const everywhere = { ...chain(3), pinned: Int32Array.of(0, 1, 2) };
    const simulation = openSimulation(everywhere, { ...usualParameters, path: 'fast' });
    const { n, dense, sparse } = compareStorage(simulation);
    expect([n, dense.bytesOfQ, sparse.bytesOfQ, sparse.bytesOfL]).toEqual([0, 0, 0, 0]);
    for (const ordering of orderings)
      expect(readElimination(simulation, ordering)).toMatchObject({ nonzeros: 0, fill: 0, flops: 0 });
  });

  it('is not tried dense where that would take seconds', async () => {
    const { n, dense, largestDense } = compareStorage(openSimulation(await openScene('flag'), usualParameters));
    expect(n).toBeGreaterThan(largestDense);
    expect(dense).toEqual({ bytesOfQ: 8 * n ** 2, bytesOfL: 8 * n ** 2, factorise: null, substitute: null });
  });
});

it('looking changes nothing', () => {
  const simulation = openSimulation(net(4), { ...usualParameters, path: 'fast' });
  simulation.step();
  simulation.next_step();
  simulation.seek(3);
  const before = { ...place(simulation), trace: simulation.trace().slice() };
  readMatrices(simulation);
  for (const ordering of orderings) readElimination(simulation, ordering);
  entriesAfter(simulation, 5);
  compareStorage(simulation);
  expect({ ...place(simulation), trace: simulation.trace().slice() }).toEqual(before);
  expect(simulation.factorisation_count()).toBe(1);
});

it('a vertex’s springs add up to its kAᵀd', () => {
  fc.assert(
    fc.property(movingScenes, (scene) => {
      const simulation = openMoving(scene);
      simulation.seek(1);
      for (let i = 0; i < scene.m.length; i++) {
        const { springs, shares, kAtd } = simulation.probe_vertex(i);
        const d = simulation.d();
        const ends = [...springs].map((e) => [scene.E[2 * e], scene.E[2 * e + 1]]);
        expect(springs).toHaveLength(scene.E.filter((vertex) => vertex === i).length);
        kAtd.forEach((whole, axis) => {
          const parts = Array.from(springs, (_, s) => shares[3 * s + axis]);
          parts.forEach((part, s) => {
            const sign = ends[s][0] === i ? 1 : -1;
            expect(part).toBe(sign * scene.parameters.k * d[3 * springs[s] + axis]);
          });
          const size = parts.reduce((sum, part) => sum + Math.abs(part), 0);
          const sum = parts.reduce((sum, part) => sum + part, 0);
          expect(Math.abs(whole - sum)).toBeLessThanOrEqual(10 * 2.3e-16 * size);
        });
      }
    }),
    { seed: 5, numRuns: 50 },
  );
});
