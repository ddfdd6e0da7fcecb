import type { RefObject } from 'preact';
import { useEffect } from 'preact/hooks';
import type { FigureSession } from './figure_session.ts';

/** Figures are awake while the element that they are drawn in is on the screen. `figures` is to be the same array from render to render. */
export function useAwake(host: RefObject<HTMLElement | null>, figures: readonly FigureSession[]): void {
  useEffect(() => {
    const observer = new IntersectionObserver(([{ isIntersecting }]) => {
      for (const figure of figures) figure.awake.value = isIntersecting;
    });
    observer.observe(host.current as HTMLElement);
    return () => observer.disconnect();
  }, [host, figures]);
}
