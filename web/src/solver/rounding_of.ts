import type { TraceEvent } from './frame.ts';

/** J: what is smaller than this in differences of E or Ẽ along a trace is nothing but rounding. */
export function roundingOf(events: readonly TraceEvent[]): number {
  return 8 * Number.EPSILON * Math.max(...events.map(largestTerm));
}

/** The sum that makes E cannot be more exact than its largest term. */
function largestTerm({ surrogate, potential, inertia, external, pin }: TraceEvent): number {
  return Math.max(...[surrogate, potential, inertia, external, pin].map(Math.abs));
}
