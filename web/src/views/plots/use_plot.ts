import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import { appliedTheme } from '../../app/preferences.ts';

/** A plot that lives in an element. One owner makes it and destroys it. */
export interface Plot<State> {
  update(state: State): void;
  /** The host's size has changed. */
  resize(): void;
  /** The page's colours have changed. */
  setTheme(): void;
  destroy(): void;
}

/** Keeps a plot in the element that the returned ref is given to. `state` should be the same object as long as nothing in it changes. */
export function usePlot<State>(create: (host: HTMLElement) => Plot<State>, state: State) {
  const host = useRef<HTMLDivElement>(null);
  const plot = useRef<Plot<State> | null>(null);

  useLayoutEffect(() => {
    const element = host.current as HTMLDivElement;
    const made = create(element);
    plot.current = made;
    const resizing = new ResizeObserver(() => made.resize());
    resizing.observe(element);
    return () => {
      resizing.disconnect();
      made.destroy();
    };
  }, []);

  useLayoutEffect(() => plot.current?.update(state), [state]);

  const theme = appliedTheme.value;
  useEffect(() => plot.current?.setTheme(), [theme]);
  return host;
}
