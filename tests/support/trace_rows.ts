import { type Simulation, traceColumns } from '../../web/src/solver/module.ts';

export type TraceRow = Record<(typeof traceColumns)[number], number>;

/** The trace, a record for each half-step. */
export function traceRows(simulation: Simulation): TraceRow[] {
  const numbers = simulation.trace();
  return Array.from({ length: numbers.length / traceColumns.length }, (_, row) => {
    const entries = traceColumns.map((name, column) => [name, numbers[row * traceColumns.length + column]]);
    return Object.fromEntries(entries) as TraceRow;
  });
}
