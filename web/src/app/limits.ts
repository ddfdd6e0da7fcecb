import { steps125 } from '../lib/steps_125.ts';
import type { Adjustable } from './state.ts';

/**
 * What the controls offer and a link may ask for. The solver has its own, physical limits (positive, finite, stiffness number); these only keep
 * sliders useful and links from asking for hours of work.
 */
export const limits: Record<Exclude<keyof Adjustable, 'wind'>, { min: number; max: number; logarithmic: boolean }> = {
  k: { min: 1, max: 1e7, logarithmic: true },
  delta_t: { min: 1e-3, max: 1, logarithmic: true },
  mass_scale: { min: 1e-2, max: 1e2, logarithmic: true },
  w: { min: 1e2, max: 1e12, logarithmic: true },
  iterations: { min: 1, max: 200, logarithmic: true },
};

/** What the views may multiply small changes by. */
export const exaggerations = steps125(1, 1000);
