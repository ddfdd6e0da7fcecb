import type { Camera } from '../../app/state.ts';
import { diagonal, screenAxes } from './screen_axes.ts';

/** One press of an arrow key, as a fraction of the scene's diagonal; ten times as much with Shift. */
const stride = 0.005;

/** To the right and up on the screen. */
const directions: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Null for other keys. */
export function directionOf(key: string): readonly [number, number] | null {
  return directions[key] ?? null;
}

/** Metres by which an arrow key moves things as the reader sees them; null for other keys. V: #V×3, metres, at rest. */
export function moveOf(
  { key, shiftKey }: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
  V: Float64Array,
  camera: Camera,
): [number, number, number] | null {
  const direction = directionOf(key);
  if (!direction) return null;
  const by = stride * diagonal(V) * (shiftKey ? 10 : 1);
  const { right, up } = screenAxes(camera);
  return right.map((value, axis) => by * (direction[0] * value + direction[1] * up[axis])) as [number, number, number];
}
