import type { Search } from '../../app/kinematics_session.ts';
import { poseAfter } from '../../app/pose.ts';
import { ikEventKinds } from '../../solver/inverse_kinematics.ts';

/** What there is to mark at an event of a search, besides where the joints are then. */
export interface ArmMoment {
  /** Where the search began: #joints×3, m. */
  ghost: Float64Array;
  /** The joint that alone has just turned, where it is, and where the effector was before and is now; #3 each, m. */
  turned: { joint: number; centre: Float64Array; before: Float64Array; after: Float64Array } | null;
  /** Whether the chain has left its root, as FABRIK's backward pass lets it. */
  detached: boolean;
}

/** After so many events. */
export function momentOf({ answer }: Search, event: number): ArmMoment {
  const [, kind, joint] = answer.events.subarray(3 * (event - 1), 3 * event); // none before the first
  const name = ikEventKinds[kind];
  const turnOf = () => {
    const before = poseAfter(answer, event - 1).x;
    const { x } = poseAfter(answer, event);
    return { joint, centre: x.subarray(3 * joint, 3 * joint + 3), before: before.subarray(-3), after: x.subarray(-3) };
  };
  return {
    ghost: answer.start_x,
    turned: event > 0 && name === 'joint' ? turnOf() : null,
    detached: event > 0 && name === 'backward',
  };
}
