import { formatQuantity } from '../../../lib/format.ts';

/** Metres in millimetres however small, so that errors and the tolerance can be compared. */
export function formatError(metres: number): string {
  return formatQuantity(1e3 * metres, 'mm');
}
