import { expect, it } from 'vitest';
import { fillTemplate } from '../../../web/src/lib/fill_template.ts';

it('fills in every name, as often as it occurs, and leaves other braces alone', () => {
  expect(fillTemplate('{{a}} of {{b}}, {{a}} {c}', { a: 1, b: '{{a}}' })).toBe('1 of {{a}}, 1 {c}');
});
