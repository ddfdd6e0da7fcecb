import fc from 'fast-check';
import { expect, it } from 'vitest';
import { type Strokes, strokesFor } from '../../../../web/src/views/scene3d/strokes.ts';

const springPixels = fc.double({ min: 0, max: 2000, noNaN: true });

it('nothing grows thinner as the camera comes nearer', () => {
  fc.assert(
    fc.property(springPixels, springPixels, (a, b) => {
      const far = strokesFor(Math.min(a, b));
      const near = strokesFor(Math.max(a, b));
      for (const name of Object.keys(far) as (keyof Strokes)[]) {
        expect(near[name]).toBeGreaterThanOrEqual(far[name]);
      }
    }),
  );
});

it('the dots at the ends of a piece leave half of its line between them', () => {
  fc.assert(
    fc.property(springPixels, (length) => {
      // They lie within its ends.
      expect(4 * strokesFor(length).pieceDot).toBeLessThanOrEqual(length / 2);
    }),
  );
});
