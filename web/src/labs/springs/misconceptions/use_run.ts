import { useEffect, useMemo } from 'preact/hooks';
import type { Actions } from '../../../app/actions.ts';
import { roomKeys } from '../../../app/room_keys.ts';
import { SideBySide } from '../../../app/side_by_side.ts';

/** The room's simulations and their clock, which the keys of the lab's clock move while the room is open; the lab's own stands still. */
export function useRun(actions: Actions): SideBySide {
  const run = useMemo(() => new SideBySide(), []);
  useEffect(() => {
    actions.pause();
    roomKeys.value = (key) => clockKey(run, key);
    const stop = run.follow();
    return () => {
      stop();
      roomKeys.value = null;
    };
  }, [run, actions]);
  return run;
}

/** Space and arrow down: one time step; A: play or pause; R: from the start. Returns whether the key meant something. */
function clockKey(run: SideBySide, key: string): boolean {
  const next = () => {
    run.playing.value = false;
    void run.run(1);
  };
  const meanings: Record<string, () => void> = {
    ' ': next,
    ArrowDown: next,
    a: () => {
      run.playing.value = run.alive.value && !run.playing.value;
    },
    r: () => void run.reset(),
  };
  const meaning = meanings[key.length === 1 ? key.toLowerCase() : key];
  meaning?.();
  return meaning !== undefined;
}
