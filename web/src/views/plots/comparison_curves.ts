import type { Method } from '../../solver/module.ts';
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
  method: Method;
  /** Of one iteration. */
  milliseconds: number;
  /** As far as E falls by more than rounding. */
  points: readonly CurvePoint[];
}

/** Where E*, the lowest objective of all the runs, was reached up to rounding. */
export interface Minimum {
  method: Method;
  iteration: number;
  /** Whether a method that came there ended because E falls no further. */
  converged: boolean;
}

/** Iterations that the horizontal axis has room for: what E* needed may be many more. */
export const shownIterations = 100;

/** Against what the gap is drawn. */
export type Abscissa = 'iterations' | 'milliseconds';

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
  const reached = curves.filter(({ points }) => points[points.length - 1].gap === null);
  const { method, points } = reached.reduce((first, next) => (next.points.length < first.points.length ? next : first));
  const converged = runs.some((run) => run.converged && reached.some((curve) => curve.method === run.method));
  return { method, iteration: points.length - 1, converged };
}

function curveOf({ method, milliseconds, change, gradient }: MethodRun, lowest: number, least: number): Curve {
  const points = Array.from(change, (value, iteration) => ({
    iteration,
    milliseconds: iteration * milliseconds,
    gap: value - lowest > least ? value - lowest : null,
    gradient: gradient[iteration],
  }));
  const floor = points.findIndex(({ gap }) => gap === null);
  return { method, milliseconds, points: floor < 0 ? points : points.slice(0, floor + 1) };
}

function lowestChange({ change }: MethodRun): number {
  return change.reduce((low, value) => Math.min(low, value));
}

/** Both ends of the horizontal axis: iterations, or whole decades of ms in which all curves find room. */
export function abscissaRange(curves: readonly Curve[], abscissa: Abscissa): [number, number] {
  if (abscissa === 'iterations') return [0, shownIterations];
  const first = curves.map(({ milliseconds }) => milliseconds);
  const last = curves.map(({ points, milliseconds }) => (points.length - 1) * milliseconds);
  return decadesAround(Math.min(...first), Math.max(...last));
}

/** Where numbers are read off at first: after the K iterations of a time step, or after the time that local/global takes for them. */
export function firstPlace(curves: readonly Curve[], abscissa: Abscissa, iterations: number): number {
  const K = Math.min(iterations, shownIterations);
  if (abscissa === 'iterations') return K;
  const { milliseconds } = curves.find(({ method }) => method === 'local-global') ?? curves[0];
  return K * milliseconds;
}

/** How far a curve has come at a place of the horizontal axis. */
export function pointAt({ points }: Curve, abscissa: Abscissa, place: number): CurvePoint {
  return points.findLast((point) => abscissaOf(point, abscissa) <= place) ?? points[0];
}
