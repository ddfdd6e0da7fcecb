import type { ColumnScale } from '../../../lib/format.ts';

/** All joints in the same unit: a millimetre is what the eye sees of an arm. */
export const metres: ColumnScale = { factor: 1, unit: 'm', decimals: 3 };

/** Of rays: they may differ by no more than a tolerance. */
export const finely: ColumnScale = { factor: 1, unit: 'm', decimals: 5 };

/** Of directions and rotations. */
export const plain: ColumnScale = { factor: 1, unit: '', decimals: 3 };
