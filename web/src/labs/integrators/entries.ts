import type { MethodChoice } from '../../app/integrators.ts';
import { oneStepMethods, toConvergence } from '../../app/integrators.ts';
import type { Method } from '../../solver/module.ts';

/** The methods offered, from the simplest on. Newton's method is offered twice: what it does in one iteration is a method of its own. */
export const entries = [
  'forward-euler',
  'symplectic-euler',
  'linearly-implicit',
  'newton-once',
  'newton',
  'local-global',
  'lbfgs',
  'anderson',
  'chebyshev',
] as const;
export type Entry = (typeof entries)[number];

/** What can be chosen besides the method itself. */
export const countsOf = { iterations: [1, 10, 50], substeps: [1, 2, 4, 8, 16, 32, 64] } as const;
export type Count = keyof typeof countsOf;

export function entryOf({ method, iterations }: MethodChoice): Entry {
  return method === 'newton' && iterations === 1 ? 'newton-once' : method;
}

/** The choice of an entry, with the usual counts. */
export function choiceOf(entry: Entry): MethodChoice {
  const method: Method = entry === 'newton-once' ? 'newton' : entry;
  const once = entry === 'newton-once' || oneStepMethods.includes(method);
  return { method, iterations: once ? 1 : entry === 'newton' ? toConvergence : 10, substeps: 1 };
}

/** Which count an entry leaves to the reader. */
export function countOf(entry: Entry): Count | null {
  if (entry === 'newton' || entry === 'newton-once') return null;
  return oneStepMethods.includes(entry) ? 'substeps' : 'iterations';
}

/** To be added: the first of these that is not there yet. */
export function nextChoice(chosen: readonly MethodChoice[]): MethodChoice {
  const present = chosen.map(entryOf);
  const order: Entry[] = ['newton', 'symplectic-euler', 'linearly-implicit', 'local-global', 'forward-euler'];
  return choiceOf(order.find((entry) => !present.includes(entry)) ?? 'local-global');
}
