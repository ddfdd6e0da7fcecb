import type { KinematicsSettings } from '../../../app/kinematics.ts';
import type { Sweep } from '../../../solver/ik_sweep.ts';
import type { Outcome } from '../../../solver/protocol.ts';
import { freeTask } from './free_task.ts';
import { useAnswer } from './use_answer.ts';
import type { Experiments } from './use_experiments.ts';

/** How a curve is followed: `limited` starts where it was, too, and may turn no joint further than a limit. */
export const sweepNames = ['warm', 'hanging', 'random', 'limited'] as const;
export type SweepName = (typeof sweepNames)[number];
export type Sweeps = Record<SweepName, Sweep>;

interface Wish {
  /** #T×3, m. */
  targets: Float64Array;
  /** Degrees. */
  limit: number;
}

/** The curve's targets, and how they were followed in all ways by the arm, method and ε of the lab; null before the first answer. */
export function useSweeps(experiments: Experiments, settings: KinematicsSettings, wish: Wish | null) {
  const { links, root, method, precision, iterations, epsilon } = settings;
  const wanted = wish && { ...wish, arm: { links, root, method, precision, iterations, epsilon } };
  const answered = useAnswer(experiments, wanted, ({ targets, limit, arm }) => {
    const task = freeTask({ ...settings, ...arm });
    return async (service): Promise<Outcome<Sweeps>> => {
      const sweeps: [SweepName, Sweep][] = [];
      for (const name of sweepNames) {
        const swept = await (name === 'limited'
          ? service.sweep({ ...task, turn_limit: (limit * Math.PI) / 180 }, targets, 'warm')
          : service.sweep(task, targets, name));
        if (!swept.ok) return swept;
        sweeps.push([name, swept.value]);
      }
      return { ok: true, value: Object.fromEntries(sweeps) as Sweeps };
    };
  });
  return answered && { sweeps: answered.answer, targets: answered.wish.targets };
}
