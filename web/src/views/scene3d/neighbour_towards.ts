import type { ScreenPoint } from './types.ts';

/** Radians either side of the direction within which something still lies in it. */
const reach = Math.PI / 3;

/** Of places on the screen the one that lies best in a direction from `here` (to the right and up, of unit length); null when none does. */
export function neighbourTowards(
  here: ScreenPoint,
  places: ReadonlyMap<number, ScreenPoint>,
  [right, up]: readonly [number, number],
): number | null {
  let best: number | null = null;
  let most = Math.cos(reach);
  for (const [vertex, { x, y }] of places) {
    const along = (x - here.x) * right - (y - here.y) * up;
    const aligned = along / Math.hypot(x - here.x, y - here.y); // NaN when the two places are one: then it lies nowhere
    if (aligned <= most || Number.isNaN(aligned)) continue;
    most = aligned;
    best = vertex;
  }
  return best;
}
