import { SolverCrash } from '../solver/client.ts';
import type { Status } from '../solver/module.ts';
import type { Outcome } from '../solver/protocol.ts';
import type { MessageKey } from './messages/index.ts';
import { notify } from './notices.ts';
import { Obstacle } from './obstacle.ts';
import { refusalParams } from './refusal_params.ts';
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

/** Why the solver refused a request. */
export function explanationOfRefusal(status: Status): Explanation {
  return { key: `page.errors.${status.code}` as MessageKey, params: refusalParams(status) };
}

/** Why a scene or the solver cannot be had, in a notice, for what has no place of its own to say it. */
export function notifyOf(reason: unknown): void {
  const { key, params } = explanationOf(reason);
  notify('error', key, params);
}

/** Why the solver refused a request, in a notice. */
export function notifyRefusal(status: Status): void {
  const { key, params } = explanationOfRefusal(status);
  notify('error', key, params);
}

/** Whether the solver has done it; says why, where it has refused. */
export function isTaken<T>(outcome: Outcome<T>): outcome is { ok: true; value: T } {
  if (!outcome.ok) notifyRefusal(outcome.status);
  return outcome.ok;
}
