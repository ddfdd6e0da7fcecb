const strides: Record<string, number> = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

/** Arrow keys, Home and End among siblings of which one is a tab stop: focuses the one they lead to, which then is it. */
export function rove(event: KeyboardEvent): void {
  const here = event.currentTarget as Element;
  const siblings = [...(here.parentElement as Element).children];
  const last = siblings.length - 1;
  const at = siblings.indexOf(here);
  const to = event.key === 'Home' ? 0 : event.key === 'End' ? last : at + (strides[event.key] ?? 0);
  const next = siblings[(to + siblings.length) % siblings.length] as SVGElement | HTMLElement;
  if (next === here) return;
  next.focus();
  event.preventDefault();
}
