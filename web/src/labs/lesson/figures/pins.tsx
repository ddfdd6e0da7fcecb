import { cardId } from '../../../app/pointing.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import type { Frame } from '../../../solver/frame.ts';
import { lessonWords } from '../lesson_words.ts';
import type { FigureSession } from './figure_session.ts';
import type { Place, Plane } from './plane.ts';
import { pulling } from './pulling.ts';

/** A press of an arrow key moves a pin so far, px; ten times as far with Shift. */
const stride = 4;

const directions: Record<string, Place> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

interface Props {
  figure: FigureSession;
  frame: Frame;
  plane: Plane;
}

/** A handle at the target of every pin, for pointer and arrow keys. It stands on the picture, not in it: SVG has no buttons. */
export function Pins({ figure, frame, plane }: Props) {
  return (
    <>
      {Array.from(frame.pinned, (vertex, row) => (
        <Pin key={vertex} figure={figure} plane={plane} vertex={vertex} place={targetPlace(frame, plane, row)} />
      ))}
    </>
  );
}

/** From every pin's target to where its vertex is: not the same before the next global step. */
export function PinLines({ frame, p, plane }: { frame: Frame; p: Float64Array; plane: Plane }) {
  return (
    <g class="pin-lines">
      {Array.from(frame.pinned, (vertex, row) => {
        const [x1, y1] = targetPlace(frame, plane, row);
        const [x2, y2] = plane.place(p, vertex);
        return <line key={vertex} {...{ x1, y1, x2, y2 }} />;
      })}
    </g>
  );
}

function targetPlace({ targets }: Frame, plane: Plane, row: number): Place {
  return plane.place(targets, row);
}

function Pin({ figure, plane, vertex, place: [x, y] }: Omit<Props, 'frame'> & { vertex: number; place: Place }) {
  const move = (event: KeyboardEvent) => {
    const direction = directions[event.key];
    if (!direction) return;
    const by = stride * (event.shiftKey ? 10 : 1);
    figure.movePin(vertex, plane.point([x + by * direction[0], y + by * direction[1]]));
    event.preventDefault();
  };
  return (
    <button
      type="button"
      class="pin"
      data-vertex={vertex}
      aria-describedby={cardId}
      style={{ left: `${x}px`, top: `${y}px` }}
      aria-label={fillTemplate(lessonWords().figure.pin, { i: vertex })}
      onFocus={() => figure.selectVertex(vertex)}
      onKeyDown={move}
      {...pulling(figure, plane, vertex)}
    />
  );
}
