import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { TraceEvent } from '../../../../web/src/solver/frame.ts';
import { placeOf } from '../../../../web/src/solver/read_frame.ts';
import { objectiveTrace } from '../../../../web/src/views/plots/objective_trace.ts';

/** The event of a half-step with spring energy `objective`, or `surrogate` while d is held, and no other term. */
function event(half_step: number, last: number, objective: number, surrogate: number): TraceEvent {
  const zero = { inertia: 0, external: 0, pin: 0, gradient: 0, residual: 0, change: 0 };
  return { half_step, ...placeOf(half_step, last), objective, surrogate, potential: objective, ...zero };
}

/** A trace as the method makes it: local steps lower Ẽ to E, global steps lower both, and E ≤ Ẽ. */
function descent(start: number, factors: readonly number[]): TraceEvent[] {
  const last = 2 * factors.length + 1;
  const events = [event(0, last, start, start)];
  let objective = start;
  for (const factor of factors) {
    events.push(event(events.length, last, objective, objective));
    const surrogate = objective * factor;
    objective = surrogate * factor;
    events.push(event(events.length, last, objective, surrogate));
  }
  events.push(event(last, last, objective, objective));
  return events;
}

const positive = (min: number, max: number) => fc.double({ min, max, noNaN: true });

const traces = fc
  .tuple(positive(1e-6, 1e6), fc.array(positive(0.1, 1), { minLength: 1, maxLength: 60 }))
  .map(([start, factors]) => descent(start, factors));

describe('objectiveTrace', () => {
  it('draws positive finite heights only', () => {
    fc.assert(
      fc.property(traces, (events) => {
        for (const { height } of objectiveTrace(events)) {
          if (height !== null) expect(height > 0 && Number.isFinite(height)).toBe(true);
        }
      }),
    );
  });

  it('never rises by more than rounding', () => {
    fc.assert(
      fc.property(traces, (events) => {
        const points = objectiveTrace(events);
        const tolerance = 4 * Number.EPSILON * events[0].objective; // two roundings of the largest value
        for (const { drop } of points) expect(drop ?? 0).toBeLessThanOrEqual(tolerance);
        const heights = points.flatMap(({ height }) => height ?? []);
        for (let i = 1; i < heights.length; i++) expect(heights[i]).toBeLessThanOrEqual(heights[i - 1] + tolerance);
      }),
    );
  });

  it('shows a hand-computed step: 8 → 8 (local) → 5 (global) → 4 (local) → 3 (global), E = 2 → accept', () => {
    const values: [number, number][] = [
      [8, 8],
      [8, 8],
      [4, 5],
      [4, 4],
      [2, 3],
      [2, 2],
    ];
    const points = objectiveTrace(values.map(([objective, surrogate], i) => event(i, 5, objective, surrogate)));
    expect(points.map(({ height }) => height)).toEqual([6, 6, 3, 2, 1, null]);
    expect(points.map(({ drop }) => drop)).toEqual([null, 0, -3, -1, -1, -1]);
  });

  it('does not draw rounding: a height of one unit in the last place of the largest term is nothing', () => {
    const large = 1e6;
    const points = objectiveTrace([
      event(0, 3, large * (1 + Number.EPSILON), large * (1 + Number.EPSILON)),
      event(1, 3, large, large),
    ]);
    expect(points.map(({ height }) => height)).toEqual([null, null]);
  });

  it('is empty for no events', () => expect(objectiveTrace([])).toEqual([]));
});
