import { useEffect } from 'preact/hooks';
import type { SideBySide } from '../../../app/side_by_side.ts';
import { diagonal } from '../../../views/scene3d/screen_axes.ts';

/** Time steps of a whole move, and how far it goes as a share of the scene's size. */
const period = 60;
const reach = 0.2;

/** While `moving`, takes all pins down from where they rest and up again: below, the picture has room for nets that hang. */
export function useMovingPins(run: SideBySide, moving: boolean): void {
  useEffect(() => {
    if (!moving) return;
    return run.step.subscribe((step) => {
      const { V } = run.scene.peek();
      const { pinned } = run.pins.peek();
      const down = (reach * diagonal(V) * (1 - Math.cos((2 * Math.PI * step) / period))) / 2; // m
      for (const vertex of pinned) {
        const [x, y, z] = V.subarray(3 * vertex, 3 * vertex + 3);
        run.movePin(vertex, [x, y - down, z]);
      }
    });
  }, [run, moving]);
}
