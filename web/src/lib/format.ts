/** Numbers as a reader sees them: a real minus sign, thin spaces before units, powers of ten written out. */

const minus = '−';
const thinSpace = '\u202f';
const superscripts: Record<string, string> = {
  '-': '⁻',
  '0': '⁰',
  '1': '¹',
  '2': '²',
  '3': '³',
  '4': '⁴',
  '5': '⁵',
  '6': '⁶',
  '7': '⁷',
  '8': '⁸',
  '9': '⁹',
};

/** Powers of ten in [smallest, largest] are written as plain decimals, all others as m × 10ⁿ. */
const plainExponents = { smallest: -3, largest: 5 };

function signed(value: number, magnitude: string): string {
  const isZero = !/[1-9∞]/.test(magnitude);
  return value < 0 && !isZero ? minus + magnitude : magnitude;
}

/** 10ⁿ, e.g. "10⁻³". */
export function formatPowerOfTen(exponent: number): string {
  return `10${[...String(exponent)].map((character) => superscripts[character]).join('')}`;
}

/** At least `digits` significant digits (integer digits are never rounded away): 3.14, −25.0, 12345, 2.10 × 10⁻¹². */
export function formatNumber(value: number, digits = 3): string {
  if (Number.isNaN(value)) return 'NaN';
  const magnitude = Math.abs(value);
  if (magnitude === Number.POSITIVE_INFINITY) return signed(value, '∞');
  if (magnitude === 0) return '0';
  const [mantissa, exponentText] = magnitude.toExponential(digits - 1).split('e') as [string, string];
  const exponent = Number(exponentText);
  if (exponent < plainExponents.smallest || exponent > plainExponents.largest) {
    return signed(value, `${mantissa} × ${formatPowerOfTen(exponent)}`);
  }
  return formatFixed(value, Math.max(0, digits - 1 - exponent));
}

/** A fixed number of decimals, for numbers that stand in a column. */
export function formatFixed(value: number, decimals: number): string {
  return signed(value, Math.abs(value).toFixed(decimals));
}

/** A number and its unit: "9.80 N". */
export function formatQuantity(value: number, unit: string, digits = 3): string {
  return formatNumber(value, digits) + thinSpace + unit;
}

/** Metres in the unit that suits their size: "1.25 m", "31.2 mm", "4.00 µm". */
export function formatLength(metres: number, digits = 3): string {
  const { unit, factor } = lengthUnit(metres);
  return formatQuantity(metres * factor, unit, digits);
}

/** Newtons, as kilonewtons where they would have five digits and more: "9.80 N", "834 kN". */
export function formatForce(newtons: number, digits = 3): string {
  return Math.abs(newtons) < 1e4 ? formatQuantity(newtons, 'N', digits) : formatQuantity(newtons / 1e3, 'kN', digits);
}

/** How all numbers of one column or table are written, so that their decimal points align: value · factor, in `unit`. */
export interface ColumnScale {
  factor: number;
  unit: string;
  decimals: number;
}

/** The scale in which `reference` shows `digits` significant digits. Lengths change unit, other quantities get a power of ten. */
export function columnScale(reference: number, unit: string, digits = 4): ColumnScale {
  const magnitude = Math.abs(reference);
  const scaled = unit === 'm' ? lengthUnit(magnitude) : powerOfTenUnit(magnitude, unit);
  const shown = magnitude * scaled.factor;
  const exponent = shown === 0 ? 0 : Math.floor(Math.log10(shown));
  return { ...scaled, decimals: Math.min(Math.max(0, digits - 1 - exponent), 12) };
}

export function formatInColumn(value: number, scale: ColumnScale): string {
  return formatFixed(value * scale.factor, scale.decimals);
}

/** Components that share one scale, and their unit: "(0.12, −9.80, 0.00) N". */
export function formatVector(components: readonly number[], unit: string, digits = 3): string {
  const scale = columnScale(Math.max(...components.map(Math.abs)), unit, digits);
  return `(${components.map((component) => formatInColumn(component, scale)).join(', ')})${thinSpace}${scale.unit}`;
}

function lengthUnit(metres: number): { unit: string; factor: number } {
  const magnitude = Math.abs(metres);
  if (magnitude >= 0.1 || magnitude < 1e-7) return { unit: 'm', factor: 1 };
  return magnitude >= 1e-4 ? { unit: 'mm', factor: 1e3 } : { unit: 'µm', factor: 1e6 };
}

function powerOfTenUnit(magnitude: number, unit: string): { unit: string; factor: number } {
  const exponent = magnitude === 0 ? 0 : Math.floor(Math.log10(magnitude));
  if (exponent >= plainExponents.smallest && exponent <= plainExponents.largest) return { unit, factor: 1 };
  const thousands = 3 * Math.floor(exponent / 3);
  return { unit: `${formatPowerOfTen(thousands)}${thinSpace}${unit}`, factor: 10 ** -thousands };
}
