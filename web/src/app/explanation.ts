import { SolverCrash } from '../solver/client.ts';
import type { MessageKey } from './messages/index.ts';
import { notify } from './notices.ts';
import { Obstacle } from './obstacle.ts';
import { SceneProblem } from './scene_problem.ts';

/** A sentence of the catalogues. */
export interface Explanation {
  key: MessageKey;
  params: Record<string, string | number>;
}

/** Why a scene or the solver cannot be had. Throws what no reader can do anything about. */
export function explanationOf(reason: unknown): Explanation {
  if (reason instanceof SolverCrash) return { key: 'page.errors.crash', params: { reason: reason.message } };
  if (reason instanceof SceneProblem || reason instanceof Obstacle) return reason;
  throw reason;
}

/** The same in a notice, for what has no place of its own to say it. */
export function notifyOf(reason: unknown): void {
  const { key, params } = explanationOf(reason);
  notify('error', key, params);
}
