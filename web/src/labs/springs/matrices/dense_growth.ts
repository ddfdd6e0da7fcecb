import type { SolvingCall, SolvingTime } from '../../../solver/time_solving.ts';

/** How the time of a dense call grows with the number of unknowns: n³ for the loops over all triples of Cholesky, n² for those of substitution. */
export const growth = { dense_factorise: 3, dense_substitute: 2 } as const;
export type DenseCall = keyof typeof growth;

/** ms at n unknowns, from a time measured at another n. */
export function extrapolated({ call, n, milliseconds }: SolvingTime & { call: DenseCall }, wanted: number): number {
  return milliseconds * (wanted / n) ** growth[call];
}

/** From how many unknowns a dense call takes longer than a budget, ms. */
export function unknownsWithin(
  { call, n, milliseconds }: SolvingTime & { call: DenseCall },
  budget_ms: number,
): number {
  return n * (budget_ms / milliseconds) ** (1 / growth[call]);
}

/** Bytes that the solver allows the matrices of a scene. */
export const memoryLimit = 450e6;

/** With so many vertices A, M and Q as dense matrices of doubles fill that; L overwrites Q. */
export function verticesInMemory(springsPerVertex: number): number {
  return Math.sqrt(memoryLimit / (8 * (springsPerVertex + 2)));
}

/** The time measured on the largest net, where small costs beside the loops weigh least. */
export function largest<Call extends SolvingCall>(
  times: readonly SolvingTime[],
  call: Call,
): (SolvingTime & { call: Call }) | null {
  const ofCall = times.filter((time): time is SolvingTime & { call: Call } => time.call === call);
  return ofCall.reduce<(SolvingTime & { call: Call }) | null>(
    (most, time) => (most && most.n >= time.n ? most : time),
    null,
  );
}
