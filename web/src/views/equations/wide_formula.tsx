import { useRef } from 'preact/hooks';
import { useKeyboardScroll } from '../../lib/use_keyboard_scroll.ts';
import { Formula } from './formula.tsx';
import './prose.css';

/** A formula on lines of its own. Where it is wider than its place it scrolls. */
export function WideFormula({ tex }: { tex: string }) {
  const host = useRef<HTMLDivElement>(null);
  useKeyboardScroll(host);
  return (
    <div ref={host} class="wide-formula">
      <Formula tex={tex} display />
    </div>
  );
}
