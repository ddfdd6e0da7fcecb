import type { Rectangle } from '../../lib/rectangle.ts';
import type { ScreenPoint } from './types.ts';

/**
 * Lays the canvas over the elements that stand for its views, and no farther: what stands below them may change its height with every half-step, and
 * a canvas that changes its size flickers. Tells where the canvas begins in its parent, and where on it the views are, CSS pixels. Returns how
 * to stop.
 */
export function followLayout(
  canvas: HTMLCanvasElement,
  views: readonly Element[],
  place: (origin: ScreenPoint, rectangles: Rectangle[]) => void,
): () => void {
  const parent = canvas.parentElement as HTMLElement;
  const follow = () => {
    const border = parent.getBoundingClientRect();
    // What is placed in it is placed from inside its border.
    const origin = { left: border.left + parent.clientLeft, top: border.top + parent.clientTop };
    const places = views.map((view) => view.getBoundingClientRect());
    const x = Math.floor(Math.min(...places.map(({ left }) => left)) - origin.left);
    const y = Math.floor(Math.min(...places.map(({ top }) => top)) - origin.top);
    canvas.style.left = `${x}px`;
    canvas.style.top = `${y}px`;
    canvas.style.width = `${Math.ceil(Math.max(...places.map(({ right }) => right)) - origin.left) - x}px`;
    canvas.style.height = `${Math.ceil(Math.max(...places.map(({ bottom }) => bottom)) - origin.top) - y}px`;
    place(
      { x, y },
      places.map(({ left, top, width, height }) => ({
        x: left - origin.left - x,
        y: top - origin.top - y,
        width,
        height,
      })),
    );
  };
  const observer = new ResizeObserver(follow);
  for (const element of [parent, ...views]) observer.observe(element);
  return () => observer.disconnect();
}
