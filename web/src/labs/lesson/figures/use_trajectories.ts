import { useEffect, useState } from 'preact/hooks';
import { notifyOf } from '../../../app/explanation.ts';
import type { Frame } from '../../../solver/frame.ts';
import type { FigureSettings } from './figure_session.ts';
import { lessonSolver } from './lesson_solver.ts';
import { trajectory } from './trajectory.ts';

/** One trajectory for each of the settings, which are to be the same array from render to render; null until all are there. A notice says why they cannot be. */
export function useTrajectories(settings: readonly FigureSettings[], steps: number): Frame[][] | null {
  const [trajectories, setTrajectories] = useState<Frame[][] | null>(null);
  useEffect(() => {
    let wanted = true;
    Promise.all(settings.map((one) => trajectory(lessonSolver, one, steps)))
      .then((all) => {
        if (wanted) setTrajectories(all);
      })
      .catch(notifyOf);
    return () => {
      wanted = false;
    };
  }, [settings, steps]);
  return trajectories;
}
