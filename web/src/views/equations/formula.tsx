import { useLayoutEffect, useRef } from 'preact/hooks';
import { highlightedSymbol } from '../../app/highlight.ts';
import { renderTeX } from './render_tex.ts';

interface Props {
  /** TeX in which symbols are written by the commands of notation/macros.ts. */
  tex: string;
  display?: boolean;
}

/** A formula whose symbols light up wherever on the page the same symbol is pointed at. */
export function Formula({ tex, display = false }: Props) {
  const host = useRef<HTMLSpanElement>(null);
  const highlighted = highlightedSymbol.value;

  useLayoutEffect(() => {
    if (host.current) host.current.innerHTML = renderTeX(tex, display);
  }, [tex, display]);

  useLayoutEffect(() => {
    for (const element of host.current?.querySelectorAll<HTMLElement>('[data-sym]') ?? []) {
      element.classList.toggle('sym-highlighted', element.dataset.sym === highlighted);
    }
  }, [tex, display, highlighted]);

  return <span ref={host} class="formula" />;
}
