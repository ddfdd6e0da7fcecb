import { formatNumber, formatQuantity } from '../lib/format.ts';
import type { Method, Status } from '../solver/module.ts';
import { t } from './messages/index.ts';

/** What fills the sentence of a refusal, page.errors.<code>. Numbers with a limit are written so that they can be compared. */
export function refusalParams({ code, field, index, value, limit }: Status) {
  switch (code) {
    case 'too_large':
      return { field, index, value: megabytes(value), limit: megabytes(limit) };
    case 'too_stiff':
      return { field, index, value: formatNumber(value), limit: formatNumber(limit) };
    case 'unstable':
      return {
        method: t(`methods.name.${field as Method}`),
        value: formatNumber(value, 2),
        limit: formatNumber(limit, 2),
      };
    default:
      return { field, index, value };
  }
}

function megabytes(bytes: number): string {
  return formatQuantity(bytes / 1e6, 'MB', 4);
}
