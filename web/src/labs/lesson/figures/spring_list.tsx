import { areAllLit, litThings } from '../../../app/highlight.ts';
import { cardId } from '../../../app/pointing.ts';
import { appliedTheme } from '../../../app/preferences.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatQuantity } from '../../../lib/format.ts';
import { darkPalette, lightPalette } from '../../../views/scene3d/palette.ts';
import { strainColour } from '../../../views/scene3d/strain_colour.ts';
import { lessonWords } from '../lesson_words.ts';
import { strain } from './drawn_springs.ts';
import type { FigureSession } from './figure_session.ts';
import type { Plane } from './plane.ts';
import { rove } from './roving.ts';
import { springPath } from './spring_path.ts';

/** The strain that has full colour: soft springs, so that it can be seen. */
export const strainRange = 0.25;

interface Props {
  figure: FigureSession;
  /** 2#E×3, m: where they are drawn, and where they are in the net. */
  ends: Float64Array;
  net: Float64Array;
  plane: Plane;
}

/** The springs as one tab stop; arrow keys go from one to the next. */
export function SpringList({ figure, ends, net, plane }: Props) {
  const words = lessonWords().figure;
  const { E } = figure.scene.value;
  const r = figure.r.value;
  const lit = litThings(figure).spring;
  const allLit = areAllLit('spring');
  const { spring: selected } = figure.selection.value;
  const scale = (appliedTheme.value === 'dark' ? darkPalette : lightPalette).strain;
  return (
    <g role="listbox" aria-label={words.springs}>
      {Array.from(r, (restLength, e) => {
        const stretch = strain(net, e, r);
        const label = fillTemplate(words.spring, {
          e,
          i: E[2 * e],
          j: E[2 * e + 1],
          strain: percent(stretch),
        });
        const places = [plane.place(ends, 2 * e), plane.place(ends, 2 * e + 1)] as const;
        const [[x1, y1], [x2, y2]] = places;
        return (
          <g
            key={e}
            class={allLit || e === lit ? 'spring lit' : 'spring'}
            data-spring={e}
            aria-describedby={cardId}
            role="option"
            tabindex={e === (selected ?? 0) ? 0 : -1}
            aria-selected={e === selected}
            aria-label={label}
            onFocus={() => figure.selectSpring(e)}
            onClick={() => figure.selectSpring(e)}
            onKeyDown={rove}
          >
            <line class="touch" {...{ x1, y1, x2, y2 }} />
            <path
              class="coil"
              d={springPath(...places, plane.length(restLength))}
              stroke={`rgb(${strainColour(stretch, strainRange, scale).join(' ')})`}
            />
          </g>
        );
      })}
    </g>
  );
}

/** "+3.1 %" */
function percent(stretch: number): string {
  return (stretch > 0 ? '+' : '') + formatQuantity(100 * stretch, '%', 2);
}
