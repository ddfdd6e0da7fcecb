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

/** Full double precision, one line a half-step; a cell is empty where there is nothing to measure. */
export function traceCsv(events: readonly TraceEvent[]): string {
  const cell = (value: number | string) => (Number.isNaN(value) ? '' : value);
  const line = (event: TraceEvent) => traceFields.map((field) => cell(event[field])).join(',');
  const lines = [traceFields.join(','), ...events.map(line)];
  return `${lines.join('\n')}\n`;
}
