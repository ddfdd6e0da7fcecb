import { steps125 } from '../lib/steps_125.ts';
import type { Adjustable, StoppingRule } from './state.ts';

/** The parameters that are numbers on a scale; a stopping rule can also be off. */
export type Scaled = Exclude<keyof Adjustable, 'wind' | 'method' | StoppingRule>;

interface Limits {
  min: number;
  max: number;
}

/**
 * What the controls offer and a link may ask for. The solver has its own, physical limits (positive, finite, stiffness number); these only keep
 * sliders useful and links from asking for hours of work.
 */
export const limits: Record<Scaled | StoppingRule, Limits> = {
  k: { min: 1, max: 1e7 },
  delta_t: { min: 1e-3, max: 1 },
  mass_scale: { min: 1e-2, max: 1e2 },
  w: { min: 1e2, max: 1e12 },
  iterations: { min: 1, max: 200 },
  stop_gradient: { min: 1e-9, max: 1e3 },
  stop_decrease: { min: 1e-15, max: 0.1 },
};

/** ε of a stopping rule just chosen: fine enough that nothing is seen of it, coarse enough that it ends time steps early. */
export const firstTolerance: Record<StoppingRule, number> = { stop_gradient: 1e-3, stop_decrease: 1e-6 };

/** What the views may multiply small changes by. */
export const exaggerations = steps125(1, 1000);
