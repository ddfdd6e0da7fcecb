import type { Arrows } from './arrows.ts';
import type { Place, Plane } from './plane.ts';

const shortest = 3; // px: less is a blot
const head = 7; // px

/** An arrow at every vertex that moves far enough to be seen. */
export function MoveArrows({ arrows: { from, to, symbol }, plane }: { arrows: Arrows; plane: Plane }) {
  return (
    <g class="arrows" data-sym={symbol}>
      {Array.from({ length: from.length / 3 }, (_, i) => (
        <path key={i} d={arrowPath(plane.place(from, i), plane.place(to, i))} />
      ))}
    </g>
  );
}

function arrowPath([x0, y0]: Place, [x1, y1]: Place): string {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < shortest) return '';
  const size = Math.min(head, length);
  const [ux, uy] = [(size * (x1 - x0)) / length, (size * (y1 - y0)) / length];
  const barb = (side: 1 | -1) => `M${x1} ${y1}L${x1 - ux - 0.6 * side * uy} ${y1 - uy + 0.6 * side * ux}`;
  return `M${x0} ${y0}L${x1} ${y1}${barb(1)}${barb(-1)}`;
}
