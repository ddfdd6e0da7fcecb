import type { RefObject } from 'preact';
import { useEffect, useMemo, useState } from 'preact/hooks';
import { Crew } from '../../../app/crew.ts';
import type { KinematicsService } from '../../../solver/kinematics_service.ts';

export type Experiments = Crew<KinematicsService>;

/** A worker apart from the arm's, which must not wait for hundreds of targets; hired by the first question, ended when the reader leaves. */
export function useExperiments(): Experiments {
  const experiments = useMemo<Experiments>(
    () =>
      new Crew(() => new Worker(new URL('../../../solver/kinematics_worker.ts', import.meta.url), { type: 'module' })),
    [],
  );
  useEffect(() => () => experiments.leave(), [experiments]);
  return experiments;
}

/** Whether an element has come into sight: not everyone scrolls so far. */
export function useSeen(element: RefObject<Element | null>): boolean {
  const [seen, setSeen] = useState(false);
  useEffect(() => {
    const sight = new IntersectionObserver((entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      sight.disconnect();
      setSeen(true);
    });
    sight.observe(element.current as Element);
    return () => sight.disconnect();
  }, [element]);
  return seen;
}
