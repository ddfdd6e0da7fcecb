import { expect, it } from 'vitest';
import { kinematicsLimits } from '../../../../../web/src/app/kinematics.ts';
import { presetNames, presets } from '../../../../../web/src/labs/kinematics/settings/presets.ts';

it.each(presetNames)('%s is an arm that a link may ask for', (name) => {
  const { links, length } = kinematicsLimits;
  expect(presets[name].length).toBeGreaterThanOrEqual(links.min);
  expect(presets[name].length).toBeLessThanOrEqual(links.max);
  for (const link of presets[name]) {
    expect(link.length).toBeGreaterThanOrEqual(length.min);
    expect(link.length).toBeLessThanOrEqual(length.max);
  }
});
