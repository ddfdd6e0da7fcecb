import { useEffect, useRef, useState } from 'preact/hooks';

/** ms without a change, after which a screen reader is told. */
const quiet = 700;

/** What a screen reader is told of something that keeps changing, the text that it begins with excepted: only what it has come to. */
export function QuietLine({ text }: { text: string }) {
  const known = useRef<string | null>(text);
  const [said, say] = useState('');
  useEffect(() => {
    if (text === known.current) return;
    known.current = null;
    const timer = setTimeout(() => say(text), quiet);
    return () => clearTimeout(timer);
  }, [text]);
  return (
    <p class="visually-hidden" aria-live="polite">
      {said}
    </p>
  );
}
