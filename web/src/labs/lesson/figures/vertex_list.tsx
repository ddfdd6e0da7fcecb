import { areAllLit, litThings } from '../../../app/highlight.ts';
import { cardId } from '../../../app/pointing.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { lessonWords } from '../lesson_words.ts';
import type { FigureSession } from './figure_session.ts';
import type { Plane } from './plane.ts';
import { pulling } from './pulling.ts';
import { rove } from './roving.ts';

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
  return (
    <g role="listbox" aria-label={words.vertices}>
      {Array.from(figure.scene.value.m, (_, i) => {
        const [x, y] = plane.place(p, i);
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
            <circle class="touch" cx={x} cy={y} r={18} />
            <circle class="dot" cx={x} cy={y} r={6} />
            <text x={x + 9} y={y - 9}>
              {i}
            </text>
          </g>
        );
      })}
    </g>
  );
}
