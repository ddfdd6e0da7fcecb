import { batch, signal } from '@preact/signals';
import { highlightedSymbol } from '../../app/highlight.ts';
import { isSymbolId } from '../../notation/symbols.ts';

/** The hook in a formula or the legend's button whose card is open: at most one on the page. */
export const pointedElement = signal<HTMLElement | null>(null);

export function pointAt(element: HTMLElement | null): void {
  const id = element?.dataset.sym;
  batch(() => {
    pointedElement.value = element;
    highlightedSymbol.value = id !== undefined && isSymbolId(id) ? id : null;
  });
}

/** A legend's button has the focus as a whole, so it comes before the hook of the formula inside it. */
function hookAt(target: EventTarget | null): HTMLElement | null {
  if (!(target instanceof Element)) return null;
  return target.closest<HTMLElement>('button[data-sym]') ?? target.closest<HTMLElement>('[data-sym]');
}

function isInCard(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest('.symbol-card') !== null;
}

/** Where the mouse passes by, a card that the keyboard opened stays. */
function pointAway(): void {
  if (pointedElement.value !== document.activeElement) pointAt(null);
}

/**
 * Handlers for an element that contains formulas and legends. A mouse opens a card by hovering, a finger by tapping
 * (its hover events come in pairs around the tap and must not close the card again), the keyboard by focus.
 */
export const pointingHandlers = {
  onPointerOver(event: PointerEvent) {
    if (event.pointerType !== 'mouse' || isInCard(event.target)) return;
    const hook = hookAt(event.target);
    if (hook) pointAt(hook);
    else pointAway();
  },
  onPointerLeave(event: PointerEvent) {
    if (event.pointerType === 'mouse') pointAway();
  },
  onClick(event: MouseEvent) {
    if (!isInCard(event.target)) pointAt(hookAt(event.target));
  },
  onFocusIn(event: FocusEvent) {
    pointAt(hookAt(event.target));
  },
  onFocusOut() {
    pointAt(null);
  },
};
