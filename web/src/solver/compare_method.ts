import { compareColumns, type Minimiser, type Simulation, type Status } from './module.ts';
import type { MethodRequest, MethodRun, Outcome } from './protocol.ts';

interface Attempt {
  status: Status;
  /** As compare() gives them, copied. */
  rows: Float64Array;
  converged: boolean;
  milliseconds: number;
}

/** ms. In a page the clock ticks every 0.1 ms: what is shorter is made again until it has taken this long. */
const leastTimed_ms = 5;

/** One method's way down from p^t, timed. What an iteration costs is not known, so few are made first, then as many as there is patience for. */
export function compareMethod(
  simulation: Simulation,
  { method, iterations, patience_ms }: MethodRequest,
): Outcome<MethodRun> {
  let made = 0;
  let next = 1;
  let attempt: Attempt;
  do {
    made = next;
    attempt = attemptOf(simulation, method, made);
    if (attempt.status.code !== 'ok') return { ok: false, status: attempt.status };
    next = Math.min(iterations, 4 * made, Math.floor((made * patience_ms) / attempt.milliseconds));
  } while (next > made && !attempt.converged);

  const change = column(attempt.rows, 'change');
  const gradient = column(attempt.rows, 'gradient');
  const decrease = column(attempt.rows, 'decrease');
  const milliseconds = meanTime(simulation, method, made, attempt) / Math.max(1, change.length - 1);
  return { ok: true, value: { method, change, gradient, decrease, converged: attempt.converged, milliseconds } };
}

function attemptOf(simulation: Simulation, method: Minimiser, iterations: number): Attempt {
  const started = performance.now();
  const { status, rows } = simulation.compare(method, iterations);
  const milliseconds = performance.now() - started;
  return {
    status,
    rows: rows.slice(),
    converged: rows.length < (iterations + 1) * compareColumns.length,
    milliseconds,
  };
}

/** ms that such an attempt takes. */
function meanTime(simulation: Simulation, method: Minimiser, iterations: number, first: Attempt): number {
  const started = performance.now() - first.milliseconds;
  let count = 1;
  for (; performance.now() - started < leastTimed_ms; count++) simulation.compare(method, iterations);
  return (performance.now() - started) / count;
}

function column(rows: Float64Array, name: (typeof compareColumns)[number]): Float64Array {
  return rows.filter((_, index) => index % compareColumns.length === compareColumns.indexOf(name));
}
