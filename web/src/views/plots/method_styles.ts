import type { Minimiser } from '../../solver/module.ts';

/** How a method's line is drawn: colour for those who see it, dashes (CSS pixels, on and off) for all. */
export const methodStyles: Record<Minimiser, { colour: string; dash: readonly number[] }> = {
  'local-global': { colour: '--symbol-Q', dash: [] },
  chebyshev: { colour: '--symbol-r', dash: [2, 3] },
  anderson: { colour: '--symbol-d', dash: [10, 4] },
  lbfgs: { colour: '--symbol-p', dash: [10, 3, 2, 3] },
  newton: { colour: '--symbol-k', dash: [4, 4] },
};
