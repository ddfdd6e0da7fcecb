import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { cardId, type Pointed, pointAway } from '../../../app/pointing.ts';
import type { Rectangle } from '../../../lib/rectangle.ts';
import { placeBeside } from './place_beside.ts';
import './cards.css';

interface Props {
  kind: string;
  name: string;
  at: Pointed;
  children: ComponentChildren;
}

/** The box of a card: beside what was pointed at wherever that scrolls, and open to the keyboard. */
export function CardFrame({ kind, name, at, children }: Props) {
  const card = useRef<HTMLDivElement>(null);
  const origin = useRef<Element | null>(null);
  const { hook } = at;

  useLayoutEffect(() => {
    const element = card.current as HTMLDivElement;
    const place = () => stand(element, at);
    place();
    const observer = new ResizeObserver(place); // values have more digits now and then
    observer.observe(element);
    document.addEventListener('scroll', place, { capture: true, passive: true });
    window.addEventListener('resize', place);
    return () => {
      observer.disconnect();
      document.removeEventListener('scroll', place, { capture: true });
      window.removeEventListener('resize', place);
    };
  });

  useLayoutEffect(() => {
    const enter = (event: Event) => {
      if ((event as MouseEvent).detail !== 0) return; // not pressed with a key
      origin.current = document.activeElement;
      card.current?.querySelector('a')?.focus();
    };
    hook.addEventListener('click', enter);
    return () => hook.removeEventListener('click', enter);
  }, [hook]);

  // The card stands at the end of the page, its hook in the midst of it: Tab goes on from there, Escape returns there.
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key !== 'Tab' && event.key !== 'Escape') return;
    if (event.shiftKey) event.preventDefault();
    (origin.current as HTMLElement | SVGElement | null)?.focus();
  };

  return (
    <div
      ref={card}
      id={cardId}
      role="dialog"
      aria-label={name}
      class="card"
      data-kind={kind}
      data-by={at.by}
      onKeyDown={onKeyDown}
    >
      {children}
    </div>
  );
}

/** Puts the card beside its hook. A hook that has left the page or the window takes its card with it. */
function stand(card: HTMLElement, at: Pointed): void {
  const anchor = anchorOf(at);
  if (!at.hook.isConnected || anchor.y + anchor.height < 0 || anchor.y > window.innerHeight) {
    pointAway();
    return;
  }
  const { x, y } = placeBeside(anchor, card.getBoundingClientRect(), {
    width: document.documentElement.clientWidth,
    height: window.innerHeight,
  });
  card.style.left = `${x}px`;
  card.style.top = `${y}px`;
}

/** A taller table, CSS pixels, would take the card too far from its cell. */
const tallest = 240;

/** What was pointed at and should stay in sight, in CSS pixels of the window: of a cell's table the whole height, for its row and column are lit. */
function anchorOf({ hook, within }: Pointed): Rectangle {
  const bounds = hook.getBoundingClientRect();
  const table = hook instanceof HTMLTableCellElement && hook.closest('table')?.getBoundingClientRect();
  if (table && table.height <= tallest) return { x: bounds.x, y: table.y, width: bounds.width, height: table.height };
  return within ? { ...within, x: bounds.x + within.x, y: bounds.y + within.y } : bounds;
}
