import { describe, expect, it } from 'vitest';
import { countEvents } from '../../../../../web/src/app/pose.ts';
import { type CcdNumbers, ccdNumbers } from '../../../../../web/src/labs/kinematics/equations/ccd_numbers.ts';
import { errorAt, momentAt } from '../../../../../web/src/labs/kinematics/trace/moment.ts';
import { armSearch, linksOf } from '../../../../support/arm_search.ts';

const momentsOf = (search: ReturnType<typeof armSearch>) =>
  Array.from({ length: countEvents(search.answer) }, (_, at) => momentAt(search, at + 1));

/** Of all joints that turned, one after the other. */
const allNumbers = (search: ReturnType<typeof armSearch>) =>
  momentsOf(search)
    .map((moment) => ccdNumbers(search, moment))
    .filter((numbers): numbers is CcdNumbers => numbers !== null);

/** rad: of an arc tangent of numbers near 1. */
const rounding = 1e-14;

describe('ccdNumbers', () => {
  it('of one link that hangs from the origin, and a target beside it: a quarter turn about +z', () => {
    const search = armSearch({ links: linksOf(1), root: [0, 0, 0], target: [1, 0, 0] });
    const [numbers] = allNumbers(search);
    expect(numbers).toMatchObject({ joint: 0, toEffector: [0, -1, 0], toTarget: [1, 0, 0] });
    expect(numbers.axis?.map((part) => part + 0)).toEqual([0, 0, 1]); // whatever the sign of a zero
    expect(numbers.theta).toBeCloseTo(Math.PI / 2, 14);
    expect(numbers.turned).toBeCloseTo(Math.PI / 2, 14);
  });

  it('has every joint turn by θ in double precision, and the error never grow', () => {
    const search = armSearch();
    for (const { theta, turned } of allNumbers(search)) expect(Math.abs(theta - turned)).toBeLessThan(rounding);
    for (const moment of momentsOf(search))
      expect(errorAt(search, moment.after)).toBeLessThanOrEqual(errorAt(search, moment.before) + rounding);
  });

  it('shows single precision turning by nothing where θ is under half a thousandth', () => {
    const small = allNumbers(armSearch({ precision: 'single', epsilon: 1e-6 })).filter(({ theta }) => theta < 3e-4);
    expect(small.length).toBeGreaterThan(0);
    for (const { turned, short } of small) expect({ turned, short }).toEqual({ turned: 0, short: 'rounded' });
  });

  it('shows a limit: no joint turns by more than it may', () => {
    const most = (5 * Math.PI) / 180;
    const numbers = allNumbers(armSearch({ turn: 5 }));
    expect(Math.max(...numbers.map(({ theta }) => theta))).toBeGreaterThan(most);
    const ofTheFirstRound = numbers.slice(0, 4).map(({ turned }) => turned);
    expect(Math.max(...ofTheFirstRound)).toBeLessThan(most + rounding);
  });

  it.each(['double', 'single'] as const)('tells a limit from rounding, in %s precision too', (precision) => {
    const [first, ...others] = allNumbers(armSearch({ turn: 5, precision }));
    expect(first.short).toBe('held');
    for (const { theta, short } of others) if (theta > 0.01) expect(short).not.toBe('rounded');
  });
});
