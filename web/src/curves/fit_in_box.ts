import type { Stroke } from './curve.ts';

/** m. As far as the lab's arm reaches with ease. */
const box = { width: 1.6, height: 0.6 };
const samplesPerPiece = 64; // that of a quarter of a circle misses its extent by 1e-4 of the radius at most

/**
 * `strokes`, whose pieces are one unit of t long, moved to the middle of the box and made as large as fits. What is lower than `leastHeight` is
 * not enlarged as if it filled the box: a full stop stays small. Null where there is nothing to see.
 */
export function fitInBox(strokes: readonly Stroke[], leastHeight = 0): Stroke[] | null {
  if (strokes.length === 0) return null;
  const bounds = {
    left: Number.POSITIVE_INFINITY,
    right: Number.NEGATIVE_INFINITY,
    bottom: Number.POSITIVE_INFINITY,
    top: Number.NEGATIVE_INFINITY,
  };
  for (const { to, at } of strokes)
    for (let k = 0; k <= to * samplesPerPiece; k++) {
      const [x, y] = at(k / samplesPerPiece);
      bounds.left = Math.min(bounds.left, x);
      bounds.right = Math.max(bounds.right, x);
      bounds.bottom = Math.min(bounds.bottom, y);
      bounds.top = Math.max(bounds.top, y);
    }
  const { left, right, bottom, top } = bounds;
  const scale = Math.min(box.width / (right - left), box.height / Math.max(top - bottom, leastHeight));
  if (!Number.isFinite(scale)) return null;
  return strokes.map((stroke) => ({
    ...stroke,
    at(t) {
      const [x, y] = stroke.at(t);
      return [scale * (x - (left + right) / 2), scale * (y - (bottom + top) / 2)];
    },
  }));
}
