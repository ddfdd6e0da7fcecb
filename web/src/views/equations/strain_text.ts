import { t } from '../../app/messages/index.ts';
import { formatQuantity } from '../../lib/format.ts';

/** A strain (dimensionless) in words; null, that of a spring of rest length 0, has none. */
export function strainText(strain: number | null): string {
  if (strain === null) return '';
  if (Math.abs(strain) < 1e-12) return t('equations.local.atRest'); // what is left is rounding
  const percent = formatQuantity(100 * Math.abs(strain), '%');
  return t(strain > 0 ? 'equations.local.stretched' : 'equations.local.squeezed', { percent });
}
