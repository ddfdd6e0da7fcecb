import fc from 'fast-check';
import { expect, it } from 'vitest';
import { type Strokes, strokesFor } from '../../../../web/src/views/scene3d/strokes.ts';

const springPixels = fc.double({ min: 0, max: 2000, noNaN: true });

it('nothing grows thinner as the camera comes nearer, but the line of a piece that turns into a zigzag', () => {
  fc.assert(
    fc.property(springPixels, springPixels, (a, b) => {
      const far = strokesFor(Math.min(a, b));
      const near = strokesFor(Math.max(a, b));
      for (const name of Object.keys(far) as (keyof Strokes)[]) {
        if (name !== 'piece') expect(near[name]).toBeGreaterThanOrEqual(far[name]);
      }
    }),
  );
});

it('the dots at the ends of two pieces leave most of a spring between them', () => {
  fc.assert(
    fc.property(springPixels, (length) => {
      expect(2 * strokesFor(length).pieceDot).toBeLessThan(Math.max(length / 4, 1e-9));
    }),
  );
});
