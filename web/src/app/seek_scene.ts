import type { Scene } from '../scene/scene.ts';
import { notify } from './notices.ts';
import { SceneProblem } from './scene_problem.ts';
import { reading } from './work.ts';

/** Null when the scene cannot be had, after a word about it, and when it is no longer wanted: another is, or none. */
export async function seekScene(find: (signal: AbortSignal) => Promise<Scene>): Promise<Scene | null> {
  const mine = new AbortController();
  reading.value?.abort();
  reading.value = mine;
  try {
    return await find(mine.signal);
  } catch (problem) {
    if (mine.signal.aborted) return null;
    if (!(problem instanceof SceneProblem)) throw problem;
    notify('error', problem.key, problem.params);
    return null;
  } finally {
    if (reading.value === mine) reading.value = null;
  }
}
