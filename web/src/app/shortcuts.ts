import type { Actions } from './actions.ts';
import { parameters, state } from './state.ts';

/**
 * The keys of the course's own program – space, A, L, R, W – and arrows for half-steps. Keys typed into a control belong to the control.
 * Returns whether the key meant something.
 */
export function shortcut(key: string, actions: Actions): boolean {
  const { view } = state.value;
  const meanings: Record<string, () => void> = {
    ' ': () => actions.nextStep(),
    a: () => actions.togglePlaying(),
    l: () => actions.setView({ springs: !view.springs }),
    r: () => actions.reset(),
    w: () => actions.setParameter('wind', !parameters.value.wind),
    ArrowRight: () => actions.nextHalfStep(),
    ArrowLeft: () => actions.previousHalfStep(),
    ArrowDown: () => actions.nextStep(),
    ArrowUp: () => actions.previousStep(),
  };
  const meaning = meanings[key.length === 1 ? key.toLowerCase() : key];
  meaning?.();
  return meaning !== undefined;
}
