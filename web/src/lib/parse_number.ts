/** Reads what people type into a number field: decimals, exponents and fractions ("1/30", "3e2", "2.5"). Null when it is none of these. */
export function parseNumber(text: string): number | null {
  const [numerator = '', denominator = '1', ...rest] = text.replace(/\s/g, '').replace('−', '-').split('/');
  if (numerator === '' || denominator === '' || rest.length > 0) return null;
  const value = Number(numerator) / Number(denominator);
  return Number.isFinite(value) ? value : null;
}
