import type { Curve, Stroke } from './curve.ts';
import { measureCurve } from './measured_curve.ts';
import type { Sampling } from './sampling.ts';

/** A part of a stroke, and what is to be divided evenly on it. */
export interface EvenStretch {
  stroke: number;
  /** #C+1. Ascending. */
  t: readonly number[];
  /** #C+1. How much there is of it up to each t, from 0. */
  upTo: readonly number[];
}

/** In the order of drawing. */
export function evenStretches(curve: Curve, sampling: Sampling): EvenStretch[] {
  if (sampling === 'parameter')
    return curve.strokes.map(({ from, to }, stroke) => ({ stroke, t: [from, to], upTo: [0, to - from] }));
  const stretches = measureCurve(curve);
  if (sampling === 'arc-length') return stretches.map(({ stroke, t, length }) => ({ stroke, t, upTo: length }));
  const sum = (of: 'length' | 'turn') =>
    stretches.reduce((total, stretch) => total + (stretch[of].at(-1) as number), 0);
  const perRadian = sum('turn') > 0 ? sum('length') / sum('turn') : 0; // a half of it all is length, the other half turning
  return stretches.map(({ stroke, t, length, turn }) => ({
    stroke,
    t,
    upTo: length.map((s, k) => s + (turn[k] as number) * perRadian),
  }));
}

/** The parameter up to which the given share of the stretch lies. */
export function parameterAt({ t, upTo }: EvenStretch, share: number): number {
  const wanted = share * (upTo.at(-1) as number);
  let below = 0;
  let above = t.length - 1;
  while (above - below > 1) {
    const middle = (below + above) >> 1;
    if ((upTo[middle] as number) <= wanted) below = middle;
    else above = middle;
  }
  const size = (upTo[above] as number) - (upTo[below] as number);
  const part = size > 0 ? (wanted - (upTo[below] as number)) / size : 0;
  return (t[below] as number) + part * ((t[above] as number) - (t[below] as number));
}

/**
 * How many steps each stretch is divided into, so that the curve has `points` points and the largest step is as small as can be: at first as
 * few as ends and corners demand, then one more wherever the steps are largest.
 */
export function stepsOf(stretches: readonly EvenStretch[], { strokes }: Curve, points: number): number[] {
  const steps = stretches.map(({ stroke, t }): number => {
    const { from, to, closed } = strokes[stroke] as Stroke;
    return closed && t[0] === from && t.at(-1) === to ? 2 : 1; // one step round a loop would be a single point
  });
  const stepSize = (i: number) => ((stretches[i] as EvenStretch).upTo.at(-1) as number) / (steps[i] as number);
  const openStrokes = strokes.filter(({ closed }) => !closed).length;
  for (let left = points - openStrokes - steps.reduce((a, b) => a + b, 0); left > 0; left--) {
    let largest = 0;
    for (let i = 1; i < steps.length; i++) if (stepSize(i) > stepSize(largest)) largest = i;
    steps[largest] = (steps[largest] as number) + 1;
  }
  return steps;
}
