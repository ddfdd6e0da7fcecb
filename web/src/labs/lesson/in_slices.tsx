import { type ComponentChildren, toChildArray } from 'preact';
import { useEffect, useState } from 'preact/hooks';

/**
 * Its children, one more after every picture, so that a long text with its formulas never keeps the page from answering. What is to come takes a
 * whole screen, so that nothing the reader sees moves.
 */
export function InSlices({ children }: { children: ComponentChildren }) {
  const all = toChildArray(children);
  const [shown, show] = useState(1);
  const complete = shown >= all.length;
  useEffect(() => {
    if (!complete) show(shown + 1);
  }, [shown, complete]);
  return (
    <>
      {all.slice(0, shown)}
      {!complete && <div class="section-to-come" />}
    </>
  );
}
