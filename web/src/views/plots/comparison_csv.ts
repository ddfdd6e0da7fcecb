import type { MethodRun } from '../../solver/protocol.ts';

/** Full double precision, one line an iterate: E(p^k) − E(p^0) in J, ‖∂E/∂p^k‖∞ in N. */
export function comparisonCsv(runs: readonly MethodRun[]): string {
  const lines = runs.flatMap(({ method, milliseconds, change, gradient }) =>
    Array.from(change, (value, k) => [method, k, k * milliseconds, value, gradient[k]].join(',')),
  );
  return `${['method,iteration,milliseconds,change,gradient', ...lines].join('\n')}\n`;
}
