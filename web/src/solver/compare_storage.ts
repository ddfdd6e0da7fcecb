import type { StorageComparison, StorageCost } from './matrices.ts';
import { medianTime } from './median_time.ts';
import type { Simulation, SolvingExample } from './module.ts';

/** Unknowns. Of so many a dense factorisation takes some tenths of a second, and of twice as many eight times that. */
const largestDense = 1000;

/** Dense against sparse, on the system that the simulation solves. */
export function compareStorage(simulation: Simulation): StorageComparison {
  const example = simulation.solving_example();
  try {
    const n = example.vertex_count();
    const dense = n > largestDense ? untried : timed(example, 'dense');
    const sparse = timed(example, 'sparse');
    return {
      n,
      dense: { bytesOfQ: example.dense_bytes(), bytesOfL: example.dense_bytes(), ...dense },
      sparse: { bytesOfQ: example.sparse_matrix_bytes(), bytesOfL: example.sparse_factor_bytes(), ...sparse },
      largestDense,
    };
  } finally {
    example.delete();
  }
}

type Times = Pick<StorageCost, 'factorise' | 'substitute'>;
const untried: Times = { factorise: null, substitute: null };

function timed(example: SolvingExample, storage: 'dense' | 'sparse'): Times {
  const timeOfCall = (call: 'factorise' | 'substitute') => medianTime(() => example[`${storage}_${call}`]());
  return { factorise: timeOfCall('factorise'), substitute: timeOfCall('substitute') };
}
