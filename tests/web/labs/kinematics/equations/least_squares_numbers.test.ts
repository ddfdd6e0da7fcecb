import { describe, expect, it } from 'vitest';
import { countEvents } from '../../../../../web/src/app/pose.ts';
import { leastSquaresNumbers } from '../../../../../web/src/labs/kinematics/equations/least_squares_numbers.ts';
import { solve3 } from '../../../../../web/src/labs/kinematics/equations/solve3.ts';
import { momentAt } from '../../../../../web/src/labs/kinematics/trace/moment.ts';
import { add, cross, dot, norm, scale, subtract, type Vector } from '../../../../../web/src/lib/vector.ts';
import { armSearch, linksOf } from '../../../../support/arm_search.ts';

type Arm = ReturnType<typeof armSearch>;

const iterations = (search: Arm) =>
  Array.from({ length: countEvents(search.answer) }, (_, at) => momentAt(search, at + 1))
    .filter(({ kind }) => kind === 'all')
    .map((moment) => leastSquaresNumbers(search, moment));

describe('leastSquaresNumbers', () => {
  const search = armSearch({ method: 'least-squares', target: [0.9, 0.2, -0.3] });
  const numbers = iterations(search);

  it('has the axes of the world crossed with the ray in the columns of J', () => {
    const [{ columns }] = iterations(
      armSearch({ links: linksOf(1), root: [0, 0, 0], target: [1, 0, 0], method: 'least-squares' }),
    );
    // s = (0, −1, 0): x × s = −z, y × s = 0, z × s = x
    expect(columns[0].map((column) => column.map((entry) => entry + 0))).toEqual([
      [0, 0, -1],
      [0, 0, 0],
      [1, 0, 0],
    ]);
  });

  it('promises J Δ', () => {
    for (const { columns, turns, promised } of numbers) {
      const sum = columns
        .flatMap((three, joint) => three.map((column, axis) => scale(turns[joint][axis], column)))
        .reduce(add);
      expect(norm(subtract(sum, promised))).toBeLessThan(1e-14); // the same products, added in another order
    }
  });

  it('finds the damping: Δ = Jᵀ(J Jᵀ + λ²I)⁻¹ e with λ² a power of two times ‖e‖²', () => {
    for (const { missing, columns, turns, share } of numbers.slice(0, 3)) {
      if (share === null) throw new Error('no damping found');
      const J = columns.flat();
      const axes = [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
      ];
      const system = axes.map((axis) =>
        J.map((column) => scale(dot(axis, column), column)).reduce(add, scale(share * dot(missing, missing), axis)),
      );
      const y = solve3(system, missing) as Vector;
      // What the turns lose by being kept in quaternions is far less.
      for (const [at, column] of J.entries()) expect(dot(column, y)).toBeCloseTo(turns[Math.floor(at / 3)][at % 3], 10);
    }
  });

  it('halves the damping after a success, or raises it by fours', () => {
    const shares = numbers.map(({ share }) => share).filter((share) => share !== null);
    expect(shares.length).toBeGreaterThan(2);
    expect(Math.log2(shares[0]) % 2).toBe(0); // 1 times fours
    for (const [at, share] of shares.slice(1).entries())
      expect(Math.log2((2 * share) / shares[at]) % 2).toBeCloseTo(0, 12);
  });

  it('says no damping where limits held the turns', () => {
    const [first] = iterations(armSearch({ method: 'least-squares', turn: 1 }));
    expect(first.share).toBeNull();
  });

  it('moves the end effector by what small turns promise', () => {
    const last = numbers.at(-1) as (typeof numbers)[number];
    const size = norm(last.moved);
    // Turns are of second order in how far it moves, on an arm about as long as 1 m.
    expect(norm(subtract(last.moved, last.promised))).toBeLessThan(10 * size ** 2);
  });
});

describe('solve3', () => {
  it('solves by hand', () => {
    expect(
      solve3(
        [
          [2, 0, 0],
          [0, 4, 0],
          [1, 0, 1],
        ],
        [2, 8, 4],
      ),
    ).toEqual([1, 2, 3]);
  });

  it('refuses what has no inverse', () => {
    const first = [1, 2, 3];
    expect(solve3([first, [4, 5, 6], first], [1, 1, 1])).toBeNull();
    expect(cross(first, first)).toEqual([0, 0, 0]);
  });
});
