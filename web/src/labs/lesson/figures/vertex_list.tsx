import { areAllLit, litThings } from '../../../app/highlight.ts';
import { cardId } from '../../../app/pointing.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { lessonWords } from '../lesson_words.ts';
import type { FigureSession } from './figure_session.ts';
import type { Place, Plane } from './plane.ts';
import { pulling } from './pulling.ts';
import { rove } from './roving.ts';

/** px from a vertex to the middle of its number. */
const labelDistance = 21;

interface Props {
  figure: FigureSession;
  /** #V×3, m. */
  p: Float64Array;
  plane: Plane;
}

/** The vertices as one tab stop; arrow keys go from one to the next, the pointer pulls at them. */
export function VertexList({ figure, p, plane }: Props) {
  const words = lessonWords().figure;
  const { vertex: selected } = figure.selection.value;
  const lit = litThings(figure).vertex;
  const allLit = areAllLit('vertex');
  const places = Array.from(figure.scene.value.m, (_, i) => plane.place(p, i));
  return (
    <g role="listbox" aria-label={words.vertices}>
      {places.map(([x, y], i) => {
        const [across, down] = awayFromSprings(i, figure.scene.value.E, places);
        return (
          <g
            key={i}
            class={allLit || i === lit ? 'vertex lit' : 'vertex'}
            data-vertex={i}
            aria-describedby={cardId}
            role="option"
            tabindex={i === (selected ?? 0) ? 0 : -1}
            aria-selected={i === selected}
            aria-label={fillTemplate(words.vertex, { i })}
            onFocus={() => figure.selectVertex(i)}
            onKeyDown={rove}
            {...pulling(figure, plane, i)}
          >
            <circle class="touch" cx={x} cy={y} r={22} />
            <circle class="dot" cx={x} cy={y} r={6} />
            <text x={x + labelDistance * across} y={y + labelDistance * down}>
              {i}
            </text>
          </g>
        );
      })}
    </g>
  );
}

/** A unit vector: from vertex i into the middle of the widest angle between its springs. */
function awayFromSprings(i: number, E: ArrayLike<number>, places: readonly Place[]): Place {
  const [x, y] = places[i];
  const angles = Array.from(E, (vertex, end) => ({ vertex, other: places[E[end ^ 1]] })) // E[end ^ 1]: the same spring's other end
    .filter(({ vertex }) => vertex === i)
    .map(({ other }) => Math.atan2(other[1] - y, other[0] - x))
    .sort((a, b) => a - b);
  const gaps = angles.map((angle, at) => (angles[at + 1] ?? angles[0] + 2 * Math.PI) - angle);
  const widest = gaps.indexOf(Math.max(...gaps));
  const middle = angles.length > 0 ? angles[widest] + gaps[widest] / 2 : -Math.PI / 2;
  return [Math.cos(middle), Math.sin(middle)];
}
