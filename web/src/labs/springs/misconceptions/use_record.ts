import { useEffect, useRef } from 'preact/hooks';
import type { SideBySide } from '../../../app/side_by_side.ts';
import { lowest, type Point } from './measures.ts';

/** Of each net since the start: the height of its lowest vertex, m, and what a time step took, ms. */
export interface NetRecord {
  heights: Point[];
  times: Point[];
}

/** Fills itself with every picture; whoever shows it is rendered anew with the run's energies. */
export function useRecord(run: SideBySide): { readonly current: readonly NetRecord[] } {
  const record = useRef<NetRecord[]>([]);
  useEffect(
    () =>
      run.states.subscribe((states) => {
        const step = run.step.peek();
        const count = states?.length ?? 0;
        if (step === 0 || record.current.length !== count)
          record.current = Array.from({ length: count }, () => ({ heights: [], times: [] }));
        states?.forEach(({ p, milliseconds, failure }, net) => {
          if (failure) return;
          record.current[net].heights.push([step, lowest(p)]);
          if (step > 0) record.current[net].times.push([step, milliseconds]);
        });
      }),
    [run],
  );
  return record;
}
