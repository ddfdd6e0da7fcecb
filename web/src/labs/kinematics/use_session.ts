import { useEffect, useMemo } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { KinematicsSession } from '../../app/kinematics_session.ts';
import { roomKeys } from '../../app/room_keys.ts';

/** The page's arm, which the keys step; the springs lab's clock stands still. */
export function useSession(actions: Actions): KinematicsSession {
  const session = useMemo(() => new KinematicsSession({ still: prefersStillness() }), []);
  useEffect(() => {
    actions.pause();
    roomKeys.value = (key) => labKey(session, key);
    const stop = session.follow();
    return () => {
      stop();
      roomKeys.value = null;
    };
  }, [session, actions]);
  return session;
}

/** A: draw or pause; left and right: one event back, forward; R: from the hanging arm. Returns whether the key meant something. */
function labKey(session: KinematicsSession, key: string): boolean {
  const { value: event } = session.event;
  const meanings: Record<string, () => void> = {
    a: () => (session.playing.value ? void session.pause() : session.play()),
    ArrowLeft: () => session.seek(event - 1),
    ArrowRight: () => session.seek(event + 1),
    r: () => void session.hang(),
  };
  const meaning = meanings[key.length === 1 ? key.toLowerCase() : key];
  meaning?.();
  return meaning !== undefined;
}

function prefersStillness(): boolean {
  return matchMedia('(prefers-reduced-motion: reduce)').matches;
}
