import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { IntegratorsSession } from '../../app/integrators_session.ts';
import { roomKeys } from '../../app/room_keys.ts';
import type { SideBySide } from '../../app/side_by_side.ts';

/** The page's simulations and their clock, which the keys move; the springs lab's own stands still. */
export function useSession(actions: Actions): SideBySide {
  const session = useMemo(() => new IntegratorsSession(), []);
  const { run } = session;
  useEffect(() => {
    actions.pause();
    roomKeys.value = (key) => clockKey(run, key);
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

/** Space and arrow down: one time step; A: play or pause; R: from the start; I: the same instant. Returns whether the key meant something. */
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
    i: () => void run.sameInstant(run.leader.peek()),
  };
  const meaning = meanings[key.length === 1 ? key.toLowerCase() : key];
  meaning?.();
  return meaning !== undefined;
}
