import { useEffect, useRef } from 'preact/hooks';
import type { SideBySide } from '../../../app/side_by_side.ts';
import { lowest, type Point, total } from './measures.ts';

/** Of each net since the start: the height of its lowest vertex, m, its energy, J, and what a time step took, ms. */
export interface NetRecord {
  heights: Point[];
  energies: Point[];
  times: Point[];
}

/** Fills itself with every picture until so many time steps are made; whoever shows it is rendered anew with the run's energies. */
export function useRecord(run: SideBySide, last: number): { readonly current: readonly NetRecord[] } {
  const record = useRef<NetRecord[]>([]);
  useEffect(
    () =>
      run.states.subscribe((states) => {
        const step = run.step.peek();
        const count = states?.length ?? 0;
        if (step === 0 || record.current.length !== count)
          record.current = Array.from({ length: count }, () => ({ heights: [], energies: [], times: [] }));
        states?.forEach(({ p, energies, milliseconds, failure }, net) => {
          if (failure || step > last) return;
          const { heights, energies: totals, times } = record.current[net];
          heights.push([step, lowest(p)]);
          if (step === 0) return;
          totals.push(...energies.map((energy, at): Point => [step - energies.length + at + 1, total(energy)]));
          times.push([step, milliseconds]);
        });
      }),
    [run, last],
  );
  return record;
}
