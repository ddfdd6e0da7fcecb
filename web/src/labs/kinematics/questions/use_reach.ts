import type { KinematicsSettings } from '../../../app/kinematics.ts';
import { leastError, shellOf } from '../../../solver/ik_shell.ts';
import { largestLinkAngle } from '../../../solver/ik_turns.ts';
import { ikMethods } from '../../../solver/inverse_kinematics.ts';
import { freeTask } from './free_task.ts';
import { placeBeside, pointOf, type TargetPlace } from './target_place.ts';
import { useAnswer } from './use_answer.ts';
import type { Experiments } from './use_experiments.ts';

type Arm = Pick<KinematicsSettings, 'links' | 'root' | 'iterations' | 'epsilon'>;

/** What all methods make of a target, in or out of reach; null before the first answer. `wish` null: nothing is asked yet. */
export function useReach(
  experiments: Experiments,
  settings: KinematicsSettings,
  wish: { arm: Arm; place: TargetPlace } | null,
) {
  const answered = useAnswer(experiments, wish, ({ arm, place }) => {
    const task = freeTask({ ...settings, ...arm, target: pointOf(place, arm.root), precision: 'double' });
    const beside = Float64Array.from(pointOf(placeBeside(place), arm.root));
    return (service) => service.reachByAll(task, beside);
  });
  if (!answered) return null;
  const { arm, place } = answered.wish;
  const least = leastError(place.distance, shellOf(arm.links.map(({ length }) => length)));
  return ikMethods.map((method) => {
    const { tested, beside, untested, again } = answered.answer[method];
    return {
      method,
      tested,
      untested,
      /** rad: by how much the arm turns for the target beside. */
      turned: largestLinkAngle(tested.x, beside.x),
      /** m: the errors of the search alone, beyond what is unavoidable, which rounding may undercut. */
      beyond: [...untested.errors].map((error) => Math.max(0, error - least)),
      /** m: how far the end effector goes in the next frame though the target stands still. */
      creeps: distanceBetween(untested.x.subarray(-3), again.x.subarray(-3)),
    };
  });
}

export type ReachByMethod = NonNullable<ReturnType<typeof useReach>>[number];

function distanceBetween(a: Float64Array, b: Float64Array): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
