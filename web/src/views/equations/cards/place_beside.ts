import type { Rectangle } from '../../../lib/rectangle.ts';

type Size = Pick<Rectangle, 'width' | 'height'>;

/** CSS pixels from the edges of the window. */
const margin = 8;

/**
 * Where in the window a card stands, its left upper corner: over the anchor where there is room, else under it, right or left of it. It touches
 * the anchor, so that a mouse can reach it, and covers it only where no side has room. Always inside the window, if that is large enough.
 */
export function placeBeside(anchor: Rectangle, card: Size, window: Size): { x: number; y: number } {
  const last = { x: window.width - card.width - margin, y: window.height - card.height - margin };
  const inside = (value: number, axis: 'x' | 'y') => Math.max(margin, Math.min(value, last[axis]));
  const x = inside(anchor.x + (anchor.width - card.width) / 2, 'x');
  const y = inside(anchor.y + (anchor.height - card.height) / 2, 'y');
  const over = anchor.y - card.height;
  const under = anchor.y + anchor.height;
  const right = anchor.x + anchor.width;
  const left = anchor.x - card.width;
  if (over >= margin) return { x, y: Math.min(over, last.y) };
  if (under <= last.y) return { x, y: Math.max(under, margin) };
  if (right <= last.x) return { x: Math.max(right, margin), y };
  if (left >= margin) return { x: Math.min(left, last.x), y };
  return { x, y: inside(under, 'y') };
}
