import { fitPowerLaw } from '../../../lib/fit_power_law.ts';
import type { Errors } from '../../../solver/order_of_accuracy.ts';

/** One line of the chart, for all methods whose errors cannot be told apart in it. */
export interface Line {
  /** Which of the methods. */
  members: readonly number[];
  points: readonly (readonly [delta_t: number, error: number])[];
  /** Of the finest half. */
  slope: number;
}

/** Of the errors: less than a tenth of a pixel on their axis. */
const sameLine = 1e-3;

/** The order that the finest half of the time steps shows. */
export function slopeOf({ errors }: Pick<Errors, 'errors'>): number {
  const finest = [...errors].sort((a, b) => a.delta_t - b.delta_t).slice(0, errors.length / 2);
  return fitPowerLaw(finest.map(({ delta_t, error }) => [delta_t, error]))?.exponent ?? Number.NaN;
}

/** The methods' lines, in the order of their first members. */
export function linesOf(methods: readonly Errors[]): Line[] {
  const lines: { members: number[]; first: Errors }[] = [];
  for (const [at, method] of methods.entries()) {
    const line = lines.find(({ first }) => coincide(first, method));
    if (line) line.members.push(at);
    else lines.push({ members: [at], first: method });
  }
  return lines.map(({ members, first }) => ({
    members,
    points: first.errors.map(({ delta_t, error }) => [delta_t, error] as const).sort(([a], [b]) => a - b),
    slope: slopeOf(first),
  }));
}

function coincide(a: Errors, b: Errors): boolean {
  return a.errors.every(({ error }, at) => Math.abs(error - b.errors[at].error) <= sameLine * error);
}
