import { expect, test } from 'vitest';
import { outcomeText as textOf } from '../../../../../web/src/labs/kinematics/equations/outcome_text.ts';
import { presets } from '../../../../../web/src/labs/kinematics/settings/presets.ts';
import { armSearch } from '../../../../support/arm_search.ts';

/** With plain spaces before units. */
const outcomeText = (search: ReturnType<typeof armSearch>) => textOf(search).replaceAll('\u202f', ' ');

test('a search says how it ended, and why', () => {
  expect(outcomeText(armSearch())).toBe('Converged: the end effector is within ε of the target.');
  expect(outcomeText(armSearch({ iterations: 2 }))).toBe(
    'All 2 iterations are made, and the error is still larger than ε.',
  );
  expect(outcomeText(armSearch({ target: [3, 1.7, 0] }))).toContain('3.00 m from the root, and the arm is 2.60 m long');
});

test('a target too near is told from one too far: links 0.3, 2, 0.5 keep 2 − 0.8 m', () => {
  const text = outcomeText(armSearch({ links: presets.hole, target: [0.6, 1.7, 0] }));
  expect(text).toContain('0.600 m from the root');
  expect(text).toContain('at least 1.20 m away');
});

test('limits are named where they hold the arm, and single precision where it does', () => {
  expect(outcomeText(armSearch({ turn: 2 }))).toMatch(/^Held back: for one target/);
  const links = presets.lab.map((link) => ({ ...link, bend: 5 }));
  expect(outcomeText(armSearch({ links, turn: 2 }))).toMatch(/^Held by its limits/);
  expect(outcomeText(armSearch({ precision: 'single', epsilon: 1e-9 }))).toContain('single precision rounds');
});
