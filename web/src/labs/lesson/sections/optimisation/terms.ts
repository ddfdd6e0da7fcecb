import type { SymbolId } from '../../../../notation/symbols.ts';
import type { Evaluation } from '../../../../solver/protocol.ts';

/** What E is made of; a pin's own term is left to the section on pins. */
export const terms = ['sum', 'springs', 'inertia', 'external'] as const;
export type Term = (typeof terms)[number];

export const termSymbols: Record<Term, SymbolId> = {
  sum: 'objective',
  springs: 'potential',
  inertia: 'inertia',
  external: 'external',
};

/** J */
export function termValue(term: Term, { potential, inertia, external }: Evaluation): number {
  switch (term) {
    case 'sum':
      return potential + inertia + external;
    case 'springs':
      return potential;
    case 'inertia':
      return inertia;
    case 'external':
      return external;
  }
}
