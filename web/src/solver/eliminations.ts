import type { Elimination, EliminationStep, EliminationStepRequest, Factor } from './matrices.ts';
import { medianTime } from './median_time.ts';
import type { Elimination as EliminationOfModule, Ordering, Simulation } from './module.ts';
import type { Outcome } from './protocol.ts';

/** All about one order; its L only where it does not take too long. */
export function readElimination(simulation: Simulation, ordering: Ordering): Elimination {
  return withElimination(simulation, ordering, (elimination) => ({
    ordering,
    order: elimination.order(),
    parent: elimination.parent(),
    counts: elimination.height().map((height) => height + 1),
    nonzerosOfQ: elimination.nonzeros_of_Q(),
    nonzeros: elimination.nonzeros(),
    fill: elimination.fill(),
    flops: elimination.flops(),
    factor: elimination.flops() > elimination.most_flops() ? null : factorOf(elimination),
    limit: elimination.most_flops(),
  }));
}

/** Q after some of its columns. */
export function readEliminationStep(
  simulation: Simulation,
  { ordering, columns }: EliminationStepRequest,
): Outcome<EliminationStep> {
  return withElimination(simulation, ordering, (elimination) => {
    const { status, ...entries } = elimination.after(columns);
    return status.code === 'ok' ? { ok: true, value: { ordering, columns, entries } } : { ok: false, status };
  });
}

function factorOf(elimination: EliminationOfModule): Factor | null {
  const { status, ...entries } = elimination.after(elimination.order().length);
  if (status.code !== 'ok') return null;
  return { ...entries, milliseconds: medianTime(() => elimination.factorise()) };
}

function withElimination<T>(
  simulation: Simulation,
  ordering: Ordering,
  use: (elimination: EliminationOfModule) => T,
): T {
  const elimination = simulation.elimination(ordering);
  try {
    return use(elimination);
  } finally {
    elimination.delete();
  }
}
