import type { Checkpoint } from '../solver/protocol.ts';
import { frame } from './state.ts';

/** What the lab's present time step starts from, for other simulations to start from too. Null before there is one. */
export function labMoment(): Checkpoint | null {
  const now = frame.peek();
  return now && { step: now.step, half_step: 0, p_curr: now.pCurr, p_prev: now.pPrev };
}
