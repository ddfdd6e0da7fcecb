import type { Method, Minimiser } from '../../../solver/module.ts';

export const methods = {
  label: 'Method',
  name: {
    'local-global': 'Local/global',
    chebyshev: 'Chebyshev',
    anderson: 'Anderson',
    lbfgs: 'L-BFGS',
    newton: 'Newton',
    'linearly-implicit': 'Linearly implicit Euler',
    'symplectic-euler': 'Symplectic Euler',
    'forward-euler': 'Forward Euler',
  } satisfies Record<Method, string>,
  explained: {
    'local-global':
      'Every iteration is one local and one global step, no more: the cheapest iteration of all, and E never rises, but it may take thousands of them.',
    chebyshev:
      'Carries each local/global iterate on along the last move, by a factor read off from how fast the moves shrink; costs a few additions more (Wang 2015).',
    anderson:
      'Mixes the last six local/global iterates so that what is left to do nearly cancels; costs some products of vectors, and counts only where E falls (Peng et al. 2018).',
    lbfgs:
      'Takes the global step as a direction, bends it by how the gradient changed in the last five iterations, and searches along it; costs some products of vectors and needs far fewer iterations (Liu et al. 2017).',
    newton:
      'Uses the exact second derivatives of E in place of Q; a handful of iterations reach the minimum, but each assembles and factorises another matrix.',
  } satisfies Record<Minimiser, string>,
  stop: {
    label: 'A time step ends',
    never: 'after K iterations',
    stop_gradient: 'once the gradient of E is ≤ ε, at most K',
    stop_decrease: 'once E falls by ≤ ε of itself, at most K',
    tolerance: 'tolerance ε',
  },
};
