import { wrap } from 'comlink';
import { SceneProblem } from './scene_problem.ts';
import type { ReadScene, SceneReading } from './scene_reader.ts';

/**
 * Reads a scene in a worker of its own, since the files of a large one take longer than the page may stand still. `addresses`: of its files, by name.
 * Throws SceneProblem when the worker fails, and the signal's reason when it is aborted.
 */
export async function readScene(
  file: string,
  addresses: Record<string, string>,
  signal?: AbortSignal,
): Promise<SceneReading> {
  const worker = new Worker(new URL('./scene_reader.ts', import.meta.url), { type: 'module' });
  const failure = new Promise<never>((_, reject) => {
    signal?.addEventListener('abort', () => reject(signal.reason));
    worker.addEventListener('error', ({ message }) => reject(new SceneProblem('page.errors.sceneReader', { message })));
  });
  try {
    return await Promise.race([wrap<ReadScene>(worker)(file, addresses), failure]);
  } finally {
    worker.terminate();
  }
}
