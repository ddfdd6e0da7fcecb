import { useEffect, useState } from 'preact/hooks';
import type { FigureSession } from '../../figures/figure_session.ts';
import { windows } from '../../figures/planar_scenes.ts';
import { settledInstant } from '../../figures/use_energies.ts';

/** s: the simulated time at which a vertex was first seen outside the figure's picture; null while it has not been. */
export function useLeaving(figure: FigureSession, vertex: number): number | null {
  const [left, setLeft] = useState<number | null>(null);
  useEffect(
    () =>
      figure.frame.subscribe(() => {
        const instant = settledInstant(figure);
        if (!instant) return;
        const { time, now } = instant;
        const [x, y] = now.subarray(3 * vertex, 3 * vertex + 2);
        const { left: leftmost, right, bottom, top } = windows[figure.settings.scene];
        const outside = x < leftmost || x > right || y < bottom || y > top;
        setLeft((before) => (before !== null && before <= time ? before : outside ? time : null));
      }),
    [figure, vertex],
  );
  return left;
}
