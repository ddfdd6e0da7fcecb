import { areAllLit, litThings } from '../../../app/highlight.ts';
import { cardId } from '../../../app/pointing.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { lessonWords } from '../lesson_words.ts';
import type { FigureSession } from './figure_session.ts';
import type { Place, Plane } from './plane.ts';
import { pulling } from './pulling.ts';
import { rove } from './roving.ts';

/** px from a vertex to the middle of its number. */
const labelDistance = 19;

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
            tabIndex={i === (selected ?? 0) ? 0 : -1}
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

/** A unit vector that leads from vertex i away from its springs; where they surround it, between them. */
function awayFromSprings(i: number, E: ArrayLike<number>, places: readonly Place[]): Place {
  let [across, down] = [0, 0];
  for (let end = 0; end < E.length; end++) {
    if (E[end] !== i) continue;
    const [x, y] = places[E[end ^ 1]]; // the other end of the same spring
    const length = Math.hypot(places[i][0] - x, places[i][1] - y);
    if (length === 0) continue;
    across += (places[i][0] - x) / length;
    down += (places[i][1] - y) / length;
  }
  const size = Math.hypot(across, down);
  return size > 0.2 ? [across / size, down / size] : [Math.SQRT1_2, -Math.SQRT1_2];
}
