import type { MechanicalEnergy } from '../../../solver/module.ts';

/** What a chart can tell two simulations apart by. */
export const measures = ['height', 'energy', 'time'] as const;
export type Measure = (typeof measures)[number];

/** Time step, and what was measured after it. */
export type Point = readonly [step: number, value: number];

/** y of the lowest of #V×3 points, m. */
export function lowest(p: Float64Array): number {
  let y = Number.POSITIVE_INFINITY;
  for (let at = 1; at < p.length; at += 3) y = Math.min(y, p[at]);
  return y;
}

/** J. */
export function total({ kinetic, springs, external }: MechanicalEnergy): number {
  return kinetic + springs + external;
}

/** Those of the points, in the order of their time steps, that are `gap` time steps and more apart. */
export function thinned(points: readonly Point[], gap: number): Point[] {
  let next = Number.NEGATIVE_INFINITY;
  return points.filter(([step]) => {
    if (step < next) return false;
    next = step + gap;
    return true;
  });
}

/** Room for a curve, and for another that leaves it on either side: what explodes would press the first one flat. */
export function rangeAround(points: readonly Point[]): readonly [min: number, max: number] | undefined {
  if (points.length < 2) return undefined;
  const values = points.map(([, value]) => value);
  const [least, most] = [Math.min(...values), Math.max(...values)];
  const extent = most - least || 1;
  return [least - extent, most + extent];
}

/** Room for curves that hardly leave one value, whose last digits would fill the whole frame otherwise. */
export function rangeOfStill(curves: readonly (readonly Point[])[]): readonly [min: number, max: number] | undefined {
  const values = curves.flat().map(([, value]) => value);
  if (values.length === 0) return undefined;
  const [least, most] = [Math.min(...values), Math.max(...values)];
  return most - least < stillness * Math.max(1, Math.abs(most)) ? [least - 1, most + 1] : undefined;
}

/** Relative, or in metres or joules where the values are small. */
const stillness = 1e-3;
