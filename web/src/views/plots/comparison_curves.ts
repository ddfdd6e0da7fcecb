import type { Minimiser } from '../../solver/module.ts';
import type { MethodRun } from '../../solver/protocol.ts';
import { decadesAround } from './log_axis.ts';

/** One iterate of one method. */
export interface CurvePoint {
  iteration: number;
  /** From the start of the time step. */
  milliseconds: number;
  /** E(p^k) − E*, J. Null when that is nothing but rounding: a log axis cannot hold it. */
  gap: number | null;
  /** ‖∂E/∂p^k‖∞, N. */
  gradient: number;
}

export interface Curve {
  method: Minimiser;
  /** Of one iteration. */
  milliseconds: number;
  /** Every iterate that was made. */
  points: readonly CurvePoint[];
  /** The first iteration that comes down to E* up to rounding; if none does, the last. */
  last: number;
}

/** Where E*, the lowest objective of all the runs, was reached up to rounding. */
export interface Minimum {
  method: Minimiser;
  iteration: number;
  /** Whether a method that came there ended because E falls no further. */
  converged: boolean;
}

/** Iterations that the horizontal axis has room for at least: what E* needed may be many more. */
export const shownIterations = 100;

/** Against what the curves are drawn. */
export type Abscissa = 'iterations' | 'milliseconds';

/** What is drawn: E(p^k) − E*, J, or ‖∂E/∂p^k‖∞, N. */
export type Ordinate = 'gap' | 'gradient';

/** On a log axis. Null where that has no place for it. */
export function heightOf({ gap, gradient }: CurvePoint, ordinate: Ordinate): number | null {
  return ordinate === 'gap' ? gap : gradient || null;
}

/** What is worth drawing: the gap down to where it is nothing but rounding, the gradient of every iterate. */
export function drawnPoints({ points, last }: Curve, ordinate: Ordinate): readonly CurvePoint[] {
  return ordinate === 'gap' ? points.slice(0, last + 1) : points;
}

export function abscissaOf(point: CurvePoint, abscissa: Abscissa): number {
  return abscissa === 'iterations' ? point.iteration : point.milliseconds;
}

/** Of the decrease of E: what the sums over all springs may differ by from one method to another. */
const roundingOfDecrease = 1e-12;

/**
 * @param runs      one at least
 * @param rounding  J: smaller gaps mean nothing
 */
export function comparisonCurves(runs: readonly MethodRun[], rounding: number): { curves: Curve[]; minimum: Minimum } {
  const lowest = Math.min(...runs.map(lowestChange));
  const least = Math.max(rounding, roundingOfDecrease * -lowest);
  const curves = runs.map((run) => curveOf(run, lowest, least));
  return { curves, minimum: minimumOf(runs, curves) };
}

/** Several may have come there up to rounding: then the one of the fewest iterations is named. */
function minimumOf(runs: readonly MethodRun[], curves: readonly Curve[]): Minimum {
  const reached = curves.filter(({ points, last }) => points[last].gap === null);
  const { method, last } = reached.reduce((first, next) => (next.last < first.last ? next : first));
  const converged = runs.some((run) => run.converged && reached.some((curve) => curve.method === run.method));
  return { method, iteration: last, converged };
}

function curveOf({ method, milliseconds, change, gradient }: MethodRun, lowest: number, least: number): Curve {
  const floor = change.findIndex((value) => value - lowest <= least);
  const last = floor < 0 ? change.length - 1 : floor;
  const points = Array.from(change, (value, iteration) => ({
    iteration,
    milliseconds: iteration * milliseconds,
    gap: floor < 0 || iteration < floor ? value - lowest : null,
    gradient: gradient[iteration],
  }));
  return { method, milliseconds, points, last };
}

function lowestChange({ change }: MethodRun): number {
  return change.reduce((low, value) => Math.min(low, value));
}

/** Both ends of the horizontal axis: iterations, K among them, or whole decades of ms in which all curves find room. */
export function abscissaRange(curves: readonly Curve[], abscissa: Abscissa, iterations: number): [number, number] {
  if (abscissa === 'iterations') return [0, Math.max(shownIterations, iterations)];
  const first = curves.map(({ milliseconds }) => milliseconds);
  const last = curves.map((curve) => curve.last * curve.milliseconds);
  return decadesAround(Math.min(...first), Math.max(...first, ...last));
}

/** Where numbers are read off at first: after the K iterations of a time step, or after the time that local/global takes for them. */
export function firstPlace(curves: readonly Curve[], abscissa: Abscissa, iterations: number): number {
  if (abscissa === 'iterations') return iterations;
  const { milliseconds } = curves.find(({ method }) => method === 'local-global') ?? curves[0];
  return iterations * milliseconds;
}

/**
 * What is left of the gap at the start after so many iterations, or as many as the method could make; 0 where that is nothing but rounding. Null
 * where there was no gap, or where the run was given up before.
 */
export function gapLeft({ points, last }: Curve, iterations: number): number | null {
  const [{ gap: first }] = points;
  const { gap } = points[Math.min(iterations, last)];
  if (first === null || (last < iterations && gap !== null)) return null;
  return (gap ?? 0) / first;
}

/** How far a curve has come at a place of the horizontal axis. */
export function pointAt({ points, last }: Curve, abscissa: Abscissa, place: number): CurvePoint {
  return points.slice(0, last + 1).findLast((point) => abscissaOf(point, abscissa) <= place) ?? points[0];
}
