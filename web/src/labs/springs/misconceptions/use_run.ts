import { useEffect, useMemo } from 'preact/hooks';
import type { Actions } from '../../../app/actions.ts';
import { roomKeys } from '../../../app/room_keys.ts';
import { SideBySide } from '../../../app/side_by_side.ts';
import { sideBySideKey } from '../../../app/side_by_side_keys.ts';

/** The room's simulations and their clock, which the keys of the lab's clock move while the room is open; the lab's own stands still. */
export function useRun(actions: Actions): SideBySide {
  const run = useMemo(() => new SideBySide(), []);
  useEffect(() => {
    actions.pause();
    roomKeys.value = (key) => sideBySideKey(run, key);
    const stop = run.follow();
    return () => {
      stop();
      roomKeys.value = null;
    };
  }, [run, actions]);
  return run;
}
