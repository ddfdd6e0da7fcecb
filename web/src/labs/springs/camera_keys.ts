import { scene3D } from './stage_signals.ts';

/** Radians a press. */
const turn = 0.1;
const closer = 1.1; // factor a press

/** The camera by keyboard: Shift and arrows turn, + and − zoom, 0 shows everything. Returns whether the key meant that. */
export function cameraKey(key: string, shift: boolean): boolean {
  const view = scene3D.value;
  const meanings: Record<string, () => void> = {
    'Shift+ArrowLeft': () => view?.orbit(-turn, 0),
    'Shift+ArrowRight': () => view?.orbit(turn, 0),
    'Shift+ArrowUp': () => view?.orbit(0, -turn),
    'Shift+ArrowDown': () => view?.orbit(0, turn),
    '+': () => view?.zoom(closer),
    '=': () => view?.zoom(closer),
    '-': () => view?.zoom(1 / closer),
    '0': () => view?.fit(),
  };
  const meaning = meanings[shift && key.startsWith('Arrow') ? `Shift+${key}` : key];
  meaning?.();
  return meaning !== undefined;
}
