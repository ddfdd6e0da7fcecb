import { expect, test } from 'vitest';
import { formatAngle } from '../../../../../web/src/labs/kinematics/equations/angles.ts';

test.each([
  [Math.PI / 2, '90.0°'],
  [0, '0.0°'],
  [1e-15, '0.0°'], // what rounding left
  [(0.0123 * Math.PI) / 180, '0.012\u202f°'],
  [(0.000012 * Math.PI) / 180, '1.2 × 10⁻⁵\u202f°'],
])('%d rad reads %s', (radians, text) => expect(formatAngle(radians)).toBe(text));
