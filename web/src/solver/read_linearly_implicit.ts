import type { LinearlyImplicitMatrices } from './matrices.ts';
import type { Simulation } from './module.ts';

export function readLinearlyImplicit(s: Simulation): LinearlyImplicitMatrices {
  const { K, D, P, system, constrained } = s.linearly_implicit_terms();
  return {
    q: s.settled().slice(),
    K,
    P,
    system,
    constrained,
    stiffness: ofSprings(s, (e) => s.spring_stiffness(e)),
    resistance: D.value.length === 0 ? null : ofSprings(s, (e) => s.spring_resistance(e)),
  };
}

/** #E×9. */
function ofSprings(s: Simulation, block: (e: number) => Float64Array): Float64Array {
  const blocks = new Float64Array(9 * s.spring_count());
  for (let e = 0; e < s.spring_count(); e++) blocks.set(block(e), 9 * e);
  return blocks;
}
