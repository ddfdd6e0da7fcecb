import { defaultKinematics, type Link } from '../../../app/kinematics.ts';

function free(lengths: readonly number[]): readonly Link[] {
  return lengths.map((length) => ({ length, bend: null }));
}

/** Arms to begin with: the lab's, and three that show something of their own. Lengths in m. */
export const presets = {
  lab: defaultKinematics.links,
  /** The one arm whose angles a triangle tells. */
  two: free([1.3, 1.3]),
  /** Nearly a rope: many poses for every target. */
  ten: free(Array.from({ length: 10 }, () => 0.26)),
  /** The middle link is longer than the others together: the arm does not come near its own root. */
  hole: free([0.3, 2, 0.5]),
} as const;

export type Preset = keyof typeof presets;
export const presetNames = Object.keys(presets) as Preset[];
