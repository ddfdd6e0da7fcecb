import { useEffect } from 'preact/hooks';
import type { SideBySide } from '../../../app/side_by_side.ts';
import { diagonal } from '../../../views/scene3d/screen_axes.ts';

/** Time steps of a whole move, and how far it goes as a share of the scene's size. */
const period = 60;
const reach = 0.15;

/** While `moving`, takes all pins up and down from where they rest. */
export function useMovingPins(run: SideBySide, moving: boolean): void {
  useEffect(() => {
    if (!moving) return;
    return run.step.subscribe((step) => {
      const { V } = run.scene.peek();
      const { pinned } = run.pins.peek();
      const up = reach * diagonal(V) * Math.sin((2 * Math.PI * step) / period); // m
      for (const vertex of pinned) {
        const [x, y, z] = V.subarray(3 * vertex, 3 * vertex + 3);
        run.movePin(vertex, [x, y + up, z]);
      }
    });
  }, [run, moving]);
}
