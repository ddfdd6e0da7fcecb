import type { RefObject } from 'preact';
import { useLayoutEffect } from 'preact/hooks';

/** Where a box is narrower than what it holds it scrolls, and then the keyboard can reach it to do so. */
export function useKeyboardScroll(host: RefObject<HTMLElement | null>): void {
  useLayoutEffect(() => {
    const element = host.current as HTMLElement;
    const observer = new ResizeObserver(() => {
      if (element.scrollWidth > element.clientWidth) element.tabIndex = 0;
      else element.removeAttribute('tabindex');
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, [host]);
}
