import { defaultKinematics, type KinematicsSettings, taskOf } from '../../web/src/app/kinematics.ts';
import type { Search } from '../../web/src/app/kinematics_session.ts';
import { solver } from './open_simulation.ts';

/** What the kinematics lab makes of settings that differ from its own by these, from a chain that hangs down. */
export function armSearch(settings: Partial<KinematicsSettings> = {}): Search {
  const task = taskOf({ ...defaultKinematics, ...settings });
  const { status, answer } = solver.inverse_kinematics(task);
  if (status.code !== 'ok') throw new Error(status.code);
  return { task, answer };
}

/** Links of these lengths, m, that bend as far as they like. */
export function linksOf(...lengths: readonly number[]) {
  return lengths.map((length) => ({ length, bend: null }));
}
