import { batch, effect, signal } from '@preact/signals';
import type { Rectangle } from '../lib/rectangle.ts';
import { isSymbolId, type SymbolId } from '../notation/symbols.ts';
import type { Figure } from './figure.ts';
import { type Highlight, highlighted, litSymbols, nothing } from './highlight.ts';

/**
 * Elements that stand for something say so in attributes, and need no handlers of their own:
 *   data-sym="d"             an occurrence of a symbol: it is marked whenever the symbol is lit
 *   data-about="d r"         belongs to these symbols without being a name of them: a cell of a matrix, a line of code
 *   data-spring, data-vertex a thing of the figure that holds the element, see `holds`
 * and, beside data-about, where in particular:
 *   data-row, data-column    a row or column of the symbol's matrix, both for an entry, with its number in data-value
 *   data-line="d.cpp 11"     a line of code
 * An element with data-points says by itself, in `highlighted`, what is pointed at in it, and shows no cards.
 */
const hooks = '[data-sym], [data-about], [data-spring], [data-vertex]';
const meaningfulAttributes = ['sym', 'about', 'spring', 'vertex', 'row', 'column', 'value', 'line'].map(
  (name) => `data-${name}`,
);
export type Hook = HTMLElement | SVGElement;

/** Where the one open card hangs, and how it was opened. */
export interface Pointed {
  hook: Hook;
  /** Where on the hook, if it is a canvas and the thing only drawn on it. CSS pixels from its corner. */
  within: Rectangle | null;
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
export function meaningOf({ sym, about, spring, vertex, row, column, value, line }: DOMStringMap): Meaning {
  const [file, lineNumber] = line?.split(' ') ?? [];
  return {
    symbols: (sym ?? about ?? '').split(' ').filter((id): id is SymbolId => isSymbolId(id)),
    spring: numberIn(spring),
    vertex: numberIn(vertex),
    place: (row ?? column) ? { row: numberIn(row), column: numberIn(column), value: numberIn(value) } : null,
    line: file ? { file, number: Number(lineNumber) } : null,
  };
}

type Meaning = Omit<Highlight, 'figure'>;

function numberIn(attribute: string | undefined): number | null {
  return attribute === undefined ? null : Number(attribute);
}

function pointAt(hook: Hook, by: Pointed['by']): void {
  open({ hook, within: null, by }, meaningOf(hook.dataset));
}

/** For what is only drawn: opens the card of something that a canvas shows at `within`. */
export function pointAtDrawn(
  canvas: HTMLCanvasElement,
  within: Rectangle,
  by: Pointed['by'],
  meaning: Partial<Meaning>,
) {
  open({ hook: canvas, within, by }, { ...nothing, ...meaning });
}

function open(at: Pointed, meaning: Meaning): void {
  batch(() => {
    pointed.value = at;
    highlighted.value = { ...meaning, figure: figureAround(at.hook) };
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

export const cardId = 'card';

function pointsItself(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest('[data-points]') !== null;
}

function isInCard(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest(`#${cardId}`) !== null;
}

/** CSS pixels that a press may wander before it is a drag. */
const tapSlack = 10;

/**
 * Follows what is pointed at on the whole page. A mouse does so by hovering, a finger by tapping (its hover events come in pairs around the tap
 * and mean nothing), the keyboard by focus. What was opened in one way stays until it is left in the same way, or something else is pointed at.
 * Who drags something looks at that: no card opens meanwhile, and an open one closes.
 */
export function followPointing(root: HTMLElement): void {
  const leave = (by: Pointed['by']) => {
    if (pointed.value?.by === by) pointAway();
  };
  let pressed = { x: 0, y: 0 };
  const hasWandered = ({ clientX, clientY }: MouseEvent) =>
    Math.hypot(clientX - pressed.x, clientY - pressed.y) > tapSlack;
  root.addEventListener('pointerover', ({ target, pointerType, buttons }) => {
    if (pointerType !== 'mouse' || buttons !== 0 || isInCard(target)) return;
    const hook = hookAt(target);
    if (!hook) leave('hover');
    else if (hook !== pointed.value?.hook) pointAt(hook, 'hover');
  });
  root.addEventListener('pointerleave', () => leave('hover'));
  root.addEventListener('pointerdown', ({ target, clientX, clientY }) => {
    pressed = { x: clientX, y: clientY };
    if (!isInCard(target) && hookAt(target) !== pointed.value?.hook) pointAway();
  });
  root.addEventListener('pointermove', (event) => {
    if (event.buttons !== 0 && pointed.value && !isInCard(event.target) && hasWandered(event)) pointAway();
  });
  root.addEventListener('click', (event) => {
    const hook = hookAt(event.target);
    if (hook && event.detail > 0 && !isInCard(event.target) && !hasWandered(event)) pointAt(hook, 'tap');
  });
  root.addEventListener('focusin', ({ target }) => {
    if (isInCard(target) || pointsItself(target)) return;
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
  followMeaning();
  effect(() => {
    root.dataset.lit = litSymbols.value.join(' ');
    root.dataset.litBy = highlighted.value.symbols.length > 0 ? 'symbol' : 'thing';
  });
}

/** A hook that comes to stand for something else – a field with another number – is pointed at anew. */
function followMeaning(): void {
  const observer = new MutationObserver(() => {
    const at = pointed.peek();
    if (at) pointAt(at.hook, at.by);
  });
  effect(() => {
    observer.disconnect();
    const at = pointed.value;
    if (at && !at.within) observer.observe(at.hook, { attributeFilter: meaningfulAttributes });
  });
}
