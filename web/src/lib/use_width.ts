import type { RefObject } from 'preact';
import { useLayoutEffect, useState } from 'preact/hooks';

/** CSS pixels: how wide an element is; 0 before it is laid out. */
export function useWidth(element: RefObject<HTMLElement | null>): number {
  const [width, setWidth] = useState(0);
  useLayoutEffect(() => {
    const measured = element.current as HTMLElement;
    const observer = new ResizeObserver(() => setWidth(measured.clientWidth)); // before the first picture, too
    observer.observe(measured);
    return () => observer.disconnect();
  }, [element]);
  return width;
}
