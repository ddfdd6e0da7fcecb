import type { SolverModule, SolvingExample } from './module.ts';
import { timeOf } from './time_of.ts';

/** What is timed of Q p = b, as SolvingExample calls it. */
export const solvingCalls = [
  'dense_inverse',
  'dense_factorise',
  'dense_substitute',
  'sparse_factorise',
  'sparse_substitute',
] as const;
export type SolvingCall = (typeof solvingCalls)[number];

/** One call on a net of n vertices. */
export interface SolvingTime {
  call: SolvingCall;
  n: number;
  milliseconds: number;
}

/** ms of a time step's solves with Q factorised beforehand, and with Q factorised before each of them. */
export interface RefactorisingTime {
  once: number;
  everyTime: number;
}

/** Calls that need one another, and the largest net they are tried on. */
const ways: readonly { calls: readonly SolvingCall[]; largestSide: number }[] = [
  { calls: ['dense_inverse'], largestSide: 45 },
  { calls: ['dense_factorise', 'dense_substitute'], largestSide: 45 },
  { calls: ['sparse_factorise', 'sparse_substitute'], largestSide: Number.POSITIVE_INFINITY },
];

/** ms. Some browsers' clocks tick once in a millisecond. */
const leastTimed_ms = 20;

/** ms. A way one of whose calls took longer is not tried on larger nets: at twice the vertices it may take eight times as long. */
const patience_ms = 250;

/** Times every call on nets of these sides, smallest first, and reports each as soon as it is known. */
export function timeSolving(solver: SolverModule, sides: readonly number[], report: (time: SolvingTime) => void): void {
  let affordable = ways;
  for (const side of sides) {
    withExample(solver, side, (example) => {
      affordable = affordable.filter(({ calls, largestSide }) => {
        if (side > largestSide) return false;
        const times = calls.map((call) => timeCall(example, call));
        for (const time of times) report(time);
        return times.every(({ milliseconds }) => milliseconds <= patience_ms);
      });
    });
  }
}

/** What it costs to factorise a Q that has not changed, on a net of that side, by dense and by sparse matrices. */
export function timeRefactorising(
  solver: SolverModule,
  side: number,
  iterations: number,
): Record<'dense' | 'sparse', RefactorisingTime> {
  return withExample(solver, side, (example) => {
    const timeOfCalls = (...calls: SolvingCall[]) =>
      timeOf((times) => {
        for (let call = 0; call < times * iterations; call++) for (const name of calls) example[name]();
      }, leastTimed_ms);
    const timesBy = (storage: 'dense' | 'sparse'): RefactorisingTime => {
      example[`${storage}_factorise`]();
      return {
        once: timeOfCalls(`${storage}_substitute`),
        everyTime: timeOfCalls(`${storage}_factorise`, `${storage}_substitute`),
      };
    };
    return { dense: timesBy('dense'), sparse: timesBy('sparse') };
  });
}

function timeCall(example: SolvingExample, call: SolvingCall): SolvingTime {
  const repeat = (times: number) => {
    for (let time = 0; time < times; time++) example[call]();
  };
  return { call, n: example.vertex_count(), milliseconds: timeOf(repeat, leastTimed_ms) };
}

function withExample<T>(solver: SolverModule, side: number, use: (example: SolvingExample) => T): T {
  const example = new solver.SolvingExample(side);
  try {
    return use(example);
  } finally {
    example.delete();
  }
}
