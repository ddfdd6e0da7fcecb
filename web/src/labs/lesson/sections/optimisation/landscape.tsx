import type { Plane } from '../../figures/plane.ts';
import type { Seen } from '../../figures/use_inspection.ts';
import { contour, levels } from './contours.ts';
import { cornerAt, free, landscape } from './landscape_grid.ts';
import type { Term } from './terms.ts';

const lines = 14;
const cross = 6; // px

/** Contour lines of E, or of a term, over all places of the free vertex, and the way that the iterates take through them. */
export function Landscape({ seen, plane, term }: { seen: Seen; plane: Plane; term: Term }) {
  const grid = landscape(term, seen.evaluations);
  const way = seen.iterates.map((p) => plane.place(p, free));
  const [x, y] = plane.place(seen.frame.prediction, free);
  const [endX, endY] = way[way.length - 1];
  return (
    <>
      {levels(grid.values, lines, term === 'external' ? 1 : 2).map((level, at) => (
        <path
          key={at}
          class="contour"
          stroke-opacity={1 - (0.75 * at) / lines}
          d={contour(grid, level)
            .map((ends) => `M${ends.map((end) => pathPoint(plane.place(cornerAt(end), 0))).join('L')}`)
            .join('')}
        />
      ))}
      <path class="landscape-prediction" d={`M${x - cross} ${y}H${x + cross}M${x} ${y - cross}V${y + cross}`} />
      <path class="landscape-way" d={`M${way.map(pathPoint).join('L')}`} />
      {way.map(([cx, cy], at) => (
        <circle key={at} class="landscape-iterate" cx={cx} cy={cy} r={2.5} />
      ))}
      <circle class="landscape-end" cx={endX} cy={endY} r={11} />
    </>
  );
}

function pathPoint([x, y]: readonly [number, number]): string {
  return `${x.toFixed(1)} ${y.toFixed(1)}`;
}
