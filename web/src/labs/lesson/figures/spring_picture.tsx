import type { ComponentChildren } from 'preact';
import { useId, useRef } from 'preact/hooks';
import { appliedTheme } from '../../../app/preferences.ts';
import { useWidth } from '../../../lib/use_width.ts';
import type { Frame } from '../../../solver/frame.ts';
import { darkPalette, lightPalette } from '../../../views/scene3d/palette.ts';
import type { Arrows } from './arrows.ts';
import { netEnds, netPositions, projectedFrom, tornEnds } from './drawn_springs.ts';
import type { FigureSession } from './figure_session.ts';
import { MoveArrows } from './move_arrows.tsx';
import { PinLines, Pins } from './pins.tsx';
import { type Window, windows } from './planar_scenes.ts';
import { Plane } from './plane.ts';
import { SpringList } from './spring_list.tsx';
import { springPath } from './spring_path.ts';
import { type HalfStep, useHalfStep } from './use_half_step.ts';
import { VertexList } from './vertex_list.tsx';
import './spring_picture.css';

/** `net`: the springs where p has them. `torn`: every spring alone at its d, the net behind it as a ghost. */
export type PictureMode = 'net' | 'torn';

interface Props {
  figure: FigureSession;
  mode: PictureMode;
  name: string;
  window?: Window | undefined;
  arrows?: ((frame: Frame) => Arrows) | undefined;
  behind?: ((drawing: Drawing) => ComponentChildren) | undefined;
}

/** A planar scene from the front. Its springs and vertices can be pointed at, focused and chosen; in the net the vertices can be pulled. */
export function SpringPicture({ figure, mode, name, window = windows[figure.settings.scene], arrows, behind }: Props) {
  const host = useRef<HTMLDivElement>(null);
  const clip = useId();
  const width = useWidth(host);
  const halfStep = useHalfStep(figure);
  const ratio = (window.right - window.left) / (window.top - window.bottom);
  const palette = appliedTheme.value === 'dark' ? darkPalette : lightPalette;
  const colours = {
    '--ghost': palette.ghost,
    '--pin': palette.pin,
    '--vertex': palette.vertex,
    '--arrow': palette.arrow,
    '--glow': palette.glow,
  };

  const drawing = halfStep && width > 0 && { figure, ...halfStep, plane: new Plane(window, width) };

  return (
    <div ref={host} class="spring-picture" style={{ ...colours, aspectRatio: ratio }}>
      {drawing && (
        <svg viewBox={`0 0 ${width} ${drawing.plane.height}`} width={width} height={drawing.plane.height}>
          <title>{name}</title>
          {behind && (
            <g class="behind" clip-path={`url(#${clip})`}>
              <clipPath id={clip}>
                <rect width={width} height={drawing.plane.height} />
              </clipPath>
              {behind(drawing)}
            </g>
          )}
          {mode === 'torn' ? <TornSprings {...drawing} /> : <Net {...drawing} arrows={arrows} />}
        </svg>
      )}
      {drawing && mode === 'net' && <Pins {...drawing} />}
    </div>
  );
}

/** What a picture is drawn from. */
export interface Drawing extends HalfStep {
  figure: FigureSession;
  plane: Plane;
}

function Net({ figure, frame, progress, plane, arrows }: Drawing & Pick<Props, 'arrows'>) {
  const p = netPositions({ frame, progress });
  const ends = netEnds(figure.scene.value, p);
  return (
    <>
      <SpringList figure={figure} ends={ends} net={ends} plane={plane} />
      <PinLines frame={frame} p={p} plane={plane} />
      <VertexList figure={figure} p={p} plane={plane} />
      {arrows && <MoveArrows arrows={arrows(frame)} plane={plane} />}
    </>
  );
}

function TornSprings({ figure, frame, progress, plane }: Drawing) {
  const scene = figure.scene.value;
  const net = netEnds(scene, projectedFrom(frame));
  return (
    <>
      <Ghost figure={figure} p={projectedFrom(frame)} ends={net} plane={plane} />
      <SpringList figure={figure} ends={tornEnds(scene, { frame, progress })} net={net} plane={plane} />
    </>
  );
}

/** The net that the springs were torn from. */
function Ghost({
  figure,
  p,
  ends,
  plane,
}: Pick<Drawing, 'figure' | 'plane'> & { p: Float64Array; ends: Float64Array }) {
  return (
    <g class="ghost">
      {Array.from(figure.r.value, (r, e) => (
        <path key={e} d={springPath(plane.place(ends, 2 * e), plane.place(ends, 2 * e + 1), plane.length(r))} />
      ))}
      {Array.from(figure.scene.value.m, (_, i) => {
        const [x, y] = plane.place(p, i);
        return <circle key={i} cx={x} cy={y} r={4} />;
      })}
    </g>
  );
}
