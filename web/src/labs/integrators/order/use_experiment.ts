import { useEffect, useRef, useState } from 'preact/hooks';
import { inTimingWorker } from '../../../app/in_timing_worker.ts';
import { t } from '../../../app/messages/index.ts';
import { Obstacle } from '../../../app/obstacle.ts';
import type { EnergyRatios } from '../../../solver/energy_of_one_spring.ts';
import type { Case, Errors } from '../../../solver/order_of_accuracy.ts';
import { products } from './products.ts';

export interface Results {
  errors: Record<Case, readonly Errors[]>;
  /** For every one of `products`. */
  energies: readonly EnergyRatios[];
}

/** Everything that is shown, computed at once in a worker of its own: then both cases and all time steps are there to switch between. */
export function useExperiment() {
  const [results, setResults] = useState<Results | null>(null);
  const [failure, setFailure] = useState<string | null>(null);
  const [running, setRunning] = useState(false);
  const stop = useRef(new AbortController());
  useEffect(() => () => stop.current.abort(), []);

  const run = async () => {
    setRunning(true);
    setFailure(null);
    try {
      const found = await inTimingWorker(stop.current.signal, async (service) => ({
        errors: { line: await service.orderOfAccuracy('line'), swing: await service.orderOfAccuracy('swing') },
        energies: await service.energyOfOneSpring(products),
      }));
      if (found) setResults(found);
    } catch (reason) {
      setFailure(reason instanceof Obstacle ? t(reason.key, reason.params) : String(reason));
    }
    setRunning(false);
  };
  return { results, failure, running, run };
}
