import type { Matrices } from './matrices.ts';
import type { Simulation } from './module.ts';

export function readMatrices(s: Simulation): Matrices {
  const { AtA, ...terms } = s.system_matrix_terms();
  return { A: s.A(), M: s.M(), C: s.C(), AtA, terms, Q: s.Q(), unknowns: s.order('natural') };
}
