import { proxy } from 'comlink';
import { useEffect, useState } from 'preact/hooks';
import { inTimingWorker } from '../../../app/in_timing_worker.ts';
import { t } from '../../../app/messages/index.ts';
import { Obstacle } from '../../../app/obstacle.ts';
import type { SolvingTime } from '../../../solver/time_solving.ts';

/** Vertices along a side of the nets: 64 to 961 unknowns, about twice as many each time. */
const sides = [8, 11, 16, 22, 31];

export interface NetTimes {
  times: readonly SolvingTime[];
  /** Why there are none, in words; null as long as there is no reason. */
  failure: string | null;
}

/** What solving costs on this computer, on nets of growing size: measured in a worker of its own, once the component is there. */
export function useNetTimes(): NetTimes {
  const [times, setTimes] = useState<readonly SolvingTime[]>([]);
  const [failure, setFailure] = useState<string | null>(null);
  useEffect(() => {
    const stop = new AbortController();
    const report = proxy((time: SolvingTime) => setTimes((before) => [...before, time]));
    inTimingWorker(stop.signal, (service) => service.timeSolving(sides, report)).catch((reason: Error) => {
      setFailure(reason instanceof Obstacle ? t(reason.key, reason.params) : reason.message);
    });
    return () => stop.abort();
  }, []);
  return { times, failure };
}
