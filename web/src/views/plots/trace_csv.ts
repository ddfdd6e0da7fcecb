import type { TraceEvent } from '../../solver/frame.ts';

/** Columns of the data table and the CSV file, in the names and units of TraceEvent. */
export const traceFields = [
  'half_step',
  'iteration',
  'phase',
  'surrogate',
  'objective',
  'potential',
  'inertia',
  'external',
  'pin',
  'gradient',
  'residual',
  'change',
] as const satisfies readonly (keyof TraceEvent)[];

/** Full double precision, one line a half-step. */
export function traceCsv(events: readonly TraceEvent[]): string {
  const lines = [traceFields.join(','), ...events.map((event) => traceFields.map((field) => event[field]).join(','))];
  return `${lines.join('\n')}\n`;
}
