import type { RefObject } from 'preact';
import { useEffect, useState } from 'preact/hooks';
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
async function measure(stop: AbortSignal): Promise<Results | null> {
  return inTimingWorker(stop, async (service) => ({
    errors: { line: await service.orderOfAccuracy('line'), swing: await service.orderOfAccuracy('swing') },
    energies: await service.energyOfOneSpring(products),
  }));
}

/** The results, once the element has come into sight: not everyone scrolls so far. */
export function useExperiment(element: RefObject<Element | null>) {
  const [results, setResults] = useState<Results | null>(null);
  const [failure, setFailure] = useState<string | null>(null);
  const [attempt, setAttempt] = useState(0);

  useEffect(() => {
    const stop = new AbortController();
    const run = () =>
      measure(stop.signal).then(setResults, (reason: unknown) =>
        setFailure(reason instanceof Obstacle ? t(reason.key, reason.params) : String(reason)),
      );
    const sight = new IntersectionObserver(([{ isIntersecting }]) => {
      if (!isIntersecting) return;
      sight.disconnect();
      void run();
    });
    sight.observe(element.current as Element);
    return () => {
      sight.disconnect();
      stop.abort();
    };
  }, [element, attempt]);

  const again = () => {
    setFailure(null);
    setAttempt(attempt + 1);
  };
  return { results, failure, again };
}
