import { type KinematicsSettings, taskOf } from '../../../app/kinematics.ts';
import type { IkTask } from '../../../solver/inverse_kinematics.ts';

/** A search by the lab's arm as if its joints had no limits, which are a question of their own. */
export function freeTask(settings: KinematicsSettings): IkTask {
  return taskOf({ ...settings, links: settings.links.map((link) => ({ ...link, bend: null })), turn: null });
}
