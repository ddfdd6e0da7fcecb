import type { ComponentChildren } from 'preact';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { t } from '../../../app/messages/index.ts';
import { holds } from '../../../app/pointing.ts';
import type { Frame } from '../../../solver/frame.ts';
import { Phrase } from '../../../views/equations/prose.tsx';
import { lessonWords } from '../lesson_words.ts';
import type { Arrows } from './arrows.ts';
import type { FigureSession } from './figure_session.ts';
import { FigureSlider, type SliderName } from './figure_slider.tsx';
import { FigureTransport } from './figure_transport.tsx';
import type { Window } from './planar_scenes.ts';
import { type Drawing, type PictureMode, SpringPicture } from './spring_picture.tsx';
import { useAwake } from './use_awake.ts';
import './figure.css';

interface Props {
  figure: FigureSession;
  /** From left to right. */
  pictures: readonly PictureMode[];
  /** Drawn over the net. */
  arrows?: (frame: Frame) => Arrows;
  /** Drawn behind it, in the same SVG. */
  behind?: (drawing: Drawing) => ComponentChildren;
  sliders?: readonly SliderName[];
  /** What the picture shows, where it is not what the scene stays in. */
  window?: Window;
  caption: string;
  /** Numbers, matrices, plots: what else shows this figure's moment. */
  children?: ComponentChildren;
}

/** A small simulation in the text: pictures, clock, sliders, caption, and the way to the lab. It sleeps when it is off the screen. */
export function Figure({ figure, pictures, arrows, behind, sliders = [], window, caption, children }: Props) {
  const host = useRef<HTMLElement>(null);
  const words = lessonWords().figure;
  const refusal = figure.refusal.value;
  const single = pictures.length === 1;
  /** A picture that stands alone is named after what it shows. */
  const nameOf = (mode: PictureMode) => (single ? t(`page.scenes.${figure.settings.scene}`) : words.pictures[mode]);

  const itself = useMemo(() => [figure], [figure]);
  useAwake(host, itself);
  useEffect(() => holds(figure)(host.current), [figure]);

  return (
    <figure ref={host} class="figure" data-awake={figure.awake.value} data-ready={figure.frame.value !== null}>
      <div class={single ? 'figure-columns' : undefined}>
        <div>
          <div class="figure-pictures">
            {pictures.map((mode) => (
              <div key={mode} class="figure-picture">
                <p class="figure-picture-name">{nameOf(mode)}</p>
                <SpringPicture
                  figure={figure}
                  mode={mode}
                  name={nameOf(mode)}
                  window={window}
                  arrows={mode === 'net' ? arrows : undefined}
                  behind={mode === 'net' ? behind : undefined}
                />
              </div>
            ))}
          </div>
          <FigureTransport figure={figure} />
        </div>
        <div class="figure-beside">
          {sliders.length > 0 && (
            <div class="figure-sliders">
              {sliders.map((name) => (
                <FigureSlider key={name} figure={figure} name={name} />
              ))}
            </div>
          )}
          {refusal && (
            <p class="figure-refusal" role="alert">
              {t(refusal.key, refusal.params)}
            </p>
          )}
          {children}
        </div>
      </div>
      <figcaption>
        <Phrase text={caption} />
      </figcaption>
    </figure>
  );
}
