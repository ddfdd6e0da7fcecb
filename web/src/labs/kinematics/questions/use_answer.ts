import type { Remote } from 'comlink';
import { useEffect, useRef, useState } from 'preact/hooks';
import { notifyRefusal } from '../../../app/explanation.ts';
import type { KinematicsService } from '../../../solver/kinematics_service.ts';
import type { Outcome } from '../../../solver/protocol.ts';
import type { Experiments } from './use_experiments.ts';

export interface Answered<Wish, Answer> {
  /** What was asked for. */
  wish: Wish;
  answer: Answer;
}

/**
 * The latest answer to what is wished for, null before the first. While one is being found, wishes replace each other: a slider makes many. The same
 * wish is one and the same JSON; a null wish asks nothing.
 */
export function useAnswer<Wish, Answer>(
  experiments: Experiments,
  wish: Wish | null,
  ask: (wish: Wish) => (service: Remote<KinematicsService>) => Promise<Outcome<Answer>>,
): Answered<Wish, Answer> | null {
  const [answered, setAnswered] = useState<Answered<Wish, Answer> | null>(null);
  const latest = useRef({ wish, done: 'null', busy: false });
  latest.current.wish = wish;

  useEffect(
    () => () => {
      latest.current.wish = null; // who has left wishes nothing: it would find a new worker, which nobody would end
    },
    [],
  );
  useEffect(() => {
    const { current } = latest;
    const pursue = async () => {
      current.busy = true;
      for (let next = current.wish; next && JSON.stringify(next) !== current.done; next = current.wish) {
        current.done = JSON.stringify(next);
        const outcome = await experiments.ask<Outcome<Answer>>(ask(next));
        if (outcome?.ok) setAnswered({ wish: next, answer: outcome.value });
        else if (outcome) notifyRefusal(outcome.status);
      }
      current.busy = false;
    };
    if (!current.busy) void pursue();
  });
  return answered;
}
