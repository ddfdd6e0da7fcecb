import { useLayoutEffect, useRef } from 'preact/hooks';
import { Formula } from './formula.tsx';
import './prose.css';

/** A formula on lines of its own. Where it is wider than its place it scrolls, and then the keyboard can reach it to do so. */
export function WideFormula({ tex }: { tex: string }) {
  const host = useRef<HTMLDivElement>(null);

  useLayoutEffect(() => {
    const element = host.current as HTMLDivElement;
    const observer = new ResizeObserver(() => {
      if (element.scrollWidth > element.clientWidth) element.tabIndex = 0;
      else element.removeAttribute('tabindex');
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, []);

  return (
    <div ref={host} class="wide-formula">
      <Formula tex={tex} display />
    </div>
  );
}
