import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { IntegratorsSession } from '../../app/integrators_session.ts';
import { roomKeys } from '../../app/room_keys.ts';
import type { SideBySide } from '../../app/side_by_side.ts';
import { sideBySideKey } from '../../app/side_by_side_keys.ts';

/** The page's simulations and their clock, which the keys move; the springs lab's own stands still. */
export function useSession(actions: Actions): SideBySide {
  const session = useMemo(() => new IntegratorsSession(), []);
  const { run } = session;
  useEffect(() => {
    actions.pause();
    roomKeys.value = (key) => labKey(run, key);
    const stop = session.follow();
    return () => {
      stop();
      roomKeys.value = null;
    };
  }, [session, run, actions]);
  useGoingOn(run);
  return run;
}

/** Whoever takes hold for the first time wants to see what comes after letting go. */
function useGoingOn(run: SideBySide): void {
  const moved = useRef(false);
  useEffect(
    () =>
      run.pull.subscribe((pull) => {
        if (!pull || moved.current) return;
        moved.current = true;
        run.playing.value = true;
      }),
    [run],
  );
}

/** The clock's keys, and I: the same instant. Returns whether the key meant something. */
function labKey(run: SideBySide, key: string): boolean {
  if (key.toLowerCase() !== 'i') return sideBySideKey(run, key);
  void run.sameInstant(run.leader.peek());
  return true;
}
