import type { SideBySide } from './side_by_side.ts';

/**
 * The keys of the lab's clock, for simulations side by side. Space and arrow down: one time step; A: play or pause; R: from the start. Returns whether
 * the key meant something.
 */
export function sideBySideKey(run: SideBySide, key: string): boolean {
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
