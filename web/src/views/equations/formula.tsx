import { useLayoutEffect, useRef } from 'preact/hooks';
import { renderTeX } from './render_tex.ts';
import 'katex/dist/katex.min.css';
import './equations.css';

interface Props {
  /** TeX in which symbols are written by the commands of notation/macros.ts. */
  tex: string;
  display?: boolean;
}

/** A formula whose symbols are linked with the same symbols everywhere on the page. */
export function Formula({ tex, display = false }: Props) {
  const host = useRef<HTMLSpanElement>(null);

  useLayoutEffect(() => {
    if (host.current) host.current.innerHTML = renderTeX(tex, display);
  }, [tex, display]);

  return <span ref={host} class="formula" />;
}
