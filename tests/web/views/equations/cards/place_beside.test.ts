import fc from 'fast-check';
import { expect, it } from 'vitest';
import { placeBeside } from '../../../../../web/src/views/equations/cards/place_beside.ts';

const phone = { width: 390, height: 844 };
const margin = 8;

it('stands over the anchor, in its middle', () => {
  expect(placeBeside({ x: 180, y: 400, width: 20, height: 20 }, { width: 100, height: 50 }, phone)).toEqual({
    x: 140,
    y: 350,
  });
});

it('stands under it near the upper edge, and right of it where there is no room over and under it', () => {
  expect(placeBeside({ x: 180, y: 20, width: 20, height: 20 }, { width: 100, height: 50 }, phone).y).toBe(40);
  const tall = { x: 100, y: 10, width: 20, height: 820 };
  expect(placeBeside(tall, { width: 100, height: 50 }, phone)).toEqual({ x: 120, y: 395 });
});

/** An anchor that can be seen, at least in part, and a card that fits into the window. */
const anchor = fc.record({
  x: fc.integer({ min: -100, max: 380 }),
  y: fc.integer({ min: -100, max: 840 }),
  width: fc.integer({ min: 0, max: 390 }),
  height: fc.integer({ min: 0, max: 844 }),
});
const card = fc.record({
  width: fc.integer({ min: 50, max: phone.width - 2 * margin }),
  height: fc.integer({ min: 20, max: phone.height - 2 * margin }),
});

it('never leaves the window', () => {
  fc.assert(
    fc.property(anchor, card, (at, size) => {
      const { x, y } = placeBeside(at, size, phone);
      expect(x).toBeGreaterThanOrEqual(margin);
      expect(y).toBeGreaterThanOrEqual(margin);
      expect(x + size.width).toBeLessThanOrEqual(phone.width - margin);
      expect(y + size.height).toBeLessThanOrEqual(phone.height - margin);
    }),
  );
});

it('covers the anchor only where no side has room', () => {
  fc.assert(
    fc.property(anchor, card, (at, size) => {
      const hasRoom =
        at.y - size.height >= margin ||
        at.y + at.height + size.height <= phone.height - margin ||
        at.x + at.width + size.width <= phone.width - margin ||
        at.x - size.width >= margin;
      const { x, y } = placeBeside(at, size, phone);
      const covers = x < at.x + at.width && x + size.width > at.x && y < at.y + at.height && y + size.height > at.y;
      if (hasRoom) expect(covers).toBe(false);
    }),
  );
});
