const decimal = '([+-]?(?:\\d+\\.?\\d*|\\.\\d+)(?:e[+-]?\\d+)?)';
const fraction = new RegExp(`^${decimal}(?:/${decimal})?$`, 'i');

/**
 * Reads what people type into a number field: decimals, exponents and fractions ("1/30", "3e2", "2.5"), full-width digits as Chinese input
 * methods give them, and the field's unit behind. Null when it is none of these.
 */
export function parseNumber(text: string, unit = ''): number | null {
  const plain = text.normalize('NFKC').replace(/\s/g, '').replace('−', '-');
  const [, numerator, denominator = '1'] = fraction.exec(unit ? plain.replace(unit, '') : plain) ?? [];
  const value = Number(numerator) / Number(denominator); // NaN where nothing matched
  return Number.isFinite(value) ? value : null;
}
