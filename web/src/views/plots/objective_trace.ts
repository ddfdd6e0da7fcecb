import type { TraceEvent } from '../../solver/frame.ts';
import { roundingOf } from '../../solver/rounding_of.ts';

/** A half-step's place in the plot. */
export interface TracePoint {
  event: TraceEvent;
  /** Ẽ(p, d) above the lowest objective of the trace, J. Null when that is nothing but rounding: a log axis cannot hold it. */
  height: number | null;
  /** What this half-step did to Ẽ, J: never positive but for rounding. Null at the first half-step. */
  drop: number | null;
}

/**
 * The half-steps of one time step as the plot shows them. Ẽ, not E: each half-step minimises Ẽ(p, d) in one of its two arguments, so each lowers Ẽ,
 * while E(p) does not depend on d and a local step leaves it where it was.
 */
export function objectiveTrace(events: readonly TraceEvent[]): TracePoint[] {
  const lowest = Math.min(...events.map((event) => event.objective));
  const rounding = roundingOf(events);
  return events.map((event, index) => {
    const height = event.surrogate - lowest;
    const before = events[index - 1];
    return {
      event,
      height: height > rounding ? height : null,
      drop: before ? event.surrogate - before.surrogate : null,
    };
  });
}
