import { batch, effect, signal } from '@preact/signals';
import { isSymbolId, type SymbolId } from '../notation/symbols.ts';
import type { Figure } from './figure.ts';
import { type Highlight, highlighted, litSymbols, nothing } from './highlight.ts';

/**
 * Elements that stand for something say so in attributes, and need no handlers of their own:
 *   data-sym="d"             an occurrence of a symbol: it is marked whenever the symbol is lit
 *   data-about="d r"         belongs to these symbols without being a name of them: a cell of a matrix, a line of code
 *   data-spring, data-vertex a thing of the figure that holds the element, see `holds`
 */
const hooks = '[data-sym], [data-about], [data-spring], [data-vertex]';
export type Hook = HTMLElement | SVGElement;

/** Where the one open card hangs, and how it was opened. */
export interface Pointed {
  hook: Hook;
  by: 'hover' | 'tap' | 'focus';
}
export const pointed = signal<Pointed | null>(null);

const figures = new WeakMap<Element, Figure>();

/** A ref for the element around everything of one figure. */
export function holds(figure: Figure): (element: Element | null) => void {
  return (element) => {
    if (element) figures.set(element, figure);
  };
}

function figureAround(hook: Element): Figure | null {
  for (let element: Element | null = hook; element; element = element.parentElement) {
    const figure = figures.get(element);
    if (figure) return figure;
  }
  return null;
}

/** What an element stands for. */
export function meaningOf({ sym, about, spring, vertex }: DOMStringMap): Omit<Highlight, 'figure'> {
  return {
    symbols: (sym ?? about ?? '').split(' ').filter((id): id is SymbolId => isSymbolId(id)),
    spring: spring === undefined ? null : Number(spring),
    vertex: vertex === undefined ? null : Number(vertex),
  };
}

function pointAt(hook: Hook, by: Pointed['by']): void {
  batch(() => {
    pointed.value = { hook, by };
    highlighted.value = { ...meaningOf(hook.dataset), figure: figureAround(hook) };
  });
}

export function pointAway(): void {
  batch(() => {
    pointed.value = null;
    highlighted.value = nothing;
  });
}

/** A button is pointed at as a whole, whatever formula is written on it. */
function hookAt(target: EventTarget | null): Hook | null {
  if (!(target instanceof Element)) return null;
  return target.closest<Hook>('button[data-sym]') ?? target.closest<Hook>(hooks);
}

export const cardId = 'symbol-card';

function isInCard(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest(`#${cardId}`) !== null;
}

/**
 * Follows what is pointed at on the whole page. A mouse does so by hovering, a finger by tapping (its hover events come in pairs around the tap
 * and mean nothing), the keyboard by focus. What was opened in one way stays until it is left in the same way, or something else is pointed at.
 */
export function followPointing(root: HTMLElement): void {
  const leave = (by: Pointed['by']) => {
    if (pointed.value?.by === by) pointAway();
  };
  root.addEventListener('pointerover', ({ target, pointerType }) => {
    if (pointerType !== 'mouse' || isInCard(target)) return;
    const hook = hookAt(target);
    if (!hook) leave('hover');
    else if (hook !== pointed.value?.hook) pointAt(hook, 'hover');
  });
  root.addEventListener('pointerleave', () => leave('hover'));
  root.addEventListener('pointerdown', ({ target }) => {
    if (!isInCard(target) && hookAt(target) !== pointed.value?.hook) pointAway();
  });
  root.addEventListener('click', ({ target, detail }) => {
    const hook = hookAt(target);
    if (hook && detail > 0 && !isInCard(target)) pointAt(hook, 'tap');
  });
  root.addEventListener('focusin', ({ target }) => {
    if (isInCard(target)) return;
    const hook = hookAt(target);
    if (hook) pointAt(hook, 'focus');
    else pointAway();
  });
  root.addEventListener('focusout', ({ relatedTarget }) => {
    if (!isInCard(relatedTarget)) leave('focus');
  });
  root.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') pointAway();
  });
  effect(() => {
    root.dataset.lit = litSymbols.value.join(' ');
    root.dataset.litBy = highlighted.value.symbols.length > 0 ? 'symbol' : 'thing';
  });
}
