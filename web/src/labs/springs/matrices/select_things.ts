import type { Actions } from '../../../app/actions.ts';
import type { Selection } from '../../../app/state.ts';

/** Selects what an entry of a matrix stands for: its vertex last, so that a spring keeps it as its end. */
export function selectThings(actions: Actions): (things: Selection) => void {
  return ({ spring, vertex }) => {
    if (spring !== null) actions.selectSpring(spring);
    if (vertex !== null) actions.selectVertex(vertex);
  };
}
